#pragma once
/// What of a problem can be placed point by point, and what has to be solved first.

#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A point that hangs on exactly d others and nothing hangs on it: it is placed when these are, on the
/// intersection of d spheres (or cylinders around lines).
struct PlacedPoint {
  int point = -1;
  std::vector<int> from;  ///< d entities
};

/// Taking away such a point leaves a problem that is well posed if the whole one is.
struct CoreReduction {
  /// What is left, in order: always d points (or a line and a point), or the fixed entities, at least.
  std::vector<int> core;
  std::vector<int> core_constraints;
  std::vector<PlacedPoint> placed;  ///< in the order of placing
  bool core_is_trivial = false;     ///< nothing is left but these: there is no system to solve
};

/// On what a point may hang.
enum class HangsOn { entities, points };

/// Precondition: the problem is well posed (see analyse_structure). Entities of `keep` (a reference, say) are
/// taken away last.
CoreReduction reduce_to_core(const ProblemStatement& problem, const std::vector<int>& keep,
                             HangsOn allowed = HangsOn::entities);

}  // namespace gcs
