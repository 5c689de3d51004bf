#pragma once
/// Numbers of solutions, exact or at most, and what they rest on.

#include <optional>
#include <string>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/problem/problem_statement.hpp"

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
  std::vector<int>
      reference;  ///< entities that make the frame: d points, a line and a point, or all given points
  std::vector<std::vector<int>> ring;  ///< the points of the ring's bodies; empty for the m-Bézout bound
  int parts = 1;  ///< of so many parts the bounds are multiplied; the reference is that of the first, no ring
  std::string
      theorem{};  ///< in words with its source, for the bound of a theorem: then there is no reference
  /// Of figures, of which the frame tells mirror images apart: so many at most, those that are their own image once. `count`
  /// is of classes, and may be no smaller where nothing says that images differ.
  std::optional<Natural> figures{};
  /// Of the m-Bézout bound: points that are at infinity in solutions at all lengths, which it is less (infinite_solutions.hpp).
  std::vector<std::vector<int>> at_infinity{};
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

}  // namespace gcs
