#pragma once
/// How many complex solutions a problem has at generic lengths, without solving it: exactly
/// (plane_count.hpp), or at most (bezout_bound.hpp, ring_bound.hpp). No lengths whatever leave more isolated
/// ones.

#include <optional>
#include <string>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/problem/problem_statement.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// One number in the three counting conventions.
struct SolutionCount {
  Natural fixed_frame;
  FrameImages images = {};

  Natural up_to_reflection() const { return fixed_frame / static_cast<std::uint32_t>(images.in_frame); }
  Natural all_signs() const { return fixed_frame * Natural(static_cast<std::uint64_t>(images.by_signs)); }
};

/// An upper bound: the m-Bézout bound, that of a ring of hinged bodies, or that of the tangents of four spheres, by
/// Bézout for a cubic and a quartic, which has neither reference nor ring.
struct CountBound {
  SolutionCount count;
  std::vector<int> reference;          ///< entities that make the frame: d points, or a line and a point
  std::vector<std::vector<int>> ring;  ///< the points of the ring's bodies; empty for the m-Bézout bound
  int parts = 1;  ///< of so many parts the bounds are multiplied; the reference is that of the first, no ring
  std::string
      theorem{};  ///< in words with its source, for the bound of a theorem: then there is no reference
};

struct TheoreticalCounts {
  std::optional<SolutionCount> exact;
  std::string why_no_exact;  ///< a sentence; empty when there is an exact count
  std::optional<CountBound> bound;
  std::string why_no_bound;  ///< a sentence; empty when there is a bound

  /// At most so many solutions: the exact count if there is one, else the bound if there is one.
  const SolutionCount* upper_limit() const {
    if (exact) return &*exact;
    return bound ? &bound->count : nullptr;
  }
};

/// Precondition: the problem is well posed (see analyse_structure). Takes seconds at most.
/// Where d points, pairwise at given distances, separate the points, the counts of the parts are multiplied.
/// Exact: points in the plane, if the core is small enough, and points in space of which all but three can be
/// placed one by one. Bound, the smaller of the two, the m-Bézout bound if they are equal: points, or points
/// and one line, and nothing fixed; lines at four distances on anything that has a limit or is given, by 12 each.
TheoreticalCounts theoretical_counts(const ProblemStatement& problem);
/// `parts`: of decompose(problem, Split::all).
TheoreticalCounts theoretical_counts(const ProblemStatement& problem, const std::vector<Part>& parts);

}  // namespace gcs
