#pragma once
/// What can be said of a problem before any solving: degrees of freedom, generic rigidity, and polygon
/// inequalities that no placement can satisfy.

#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// One reason why a problem is not well posed. Constraints and entities are named as in the problem.
struct StructureDefect {
  enum class Kind { under_constrained, over_constrained, wrongly_constrained, unsatisfiable };
  Kind kind;
  std::vector<int> entities;     ///< loose entities, or those of the violated inequality
  std::vector<int> constraints;  ///< redundant (a dependent set), or those of the violated inequality
  std::string what;              ///< one sentence: what is wrong
  std::string remedy;            ///< one sentence: what would be right
};

struct Structure {
  int unknowns = 0;      ///< free coordinates after the frame is fixed (a free line counts 4, a free point d)
  int constraints = 0;   ///< number of constraints
  int generic_rank = 0;  ///< rank of the rigidity matrix at random placements
  std::vector<StructureDefect> defects;

  bool well_posed() const { return defects.empty(); }
};

/// Rank over a prime field at random integer placements: a rank that is reached is proven, a rank that is
/// missed is missed with a probability below 1e-15. Deterministic. Never throws.
Structure analyse_structure(const ProblemStatement& problem);

/// Of general scenes nothing is asked here: see require_general_well_posed.
/// Throws InputError with the first defect, as of a file of that name: a single constraint is pointed at, a set of
/// them is named by the message.
void require_well_posed(const ProblemStatement& problem, const std::string& file);

}  // namespace gcs
