#pragma once
/// The multihomogeneous Bézout bound on the number of solutions, as orientations of the constraint graph.
/// E. Bartzos, I. Emiris, J. Schicho: On the multihomogeneous Bézout bound on the number of embeddings of
/// minimally rigid graphs. AAECC 31 (2020).

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solvers/numeric/natural.hpp"

namespace gcs {

/// Points by numbers from 0, or planes in their place, and perhaps one line, which is the x-axis.
struct BoundProblem {
  int dimension = 3;
  std::vector<std::array<int, 2>> edges;     ///< given distances of two points
  std::vector<bool> on_line;                 ///< one per point: whether its distance from the line is given
  std::vector<std::vector<int>> references;  ///< points that may be held fixed together to make a frame
  bool are_points = true;                    ///< none of them is a plane
};

struct BezoutBound {
  Natural fixed_frame;
  std::size_t reference = 0;  ///< which of the references gives it
  /// Points that in some of the solutions counted are at infinity, at all lengths: the bound is less these solutions.
  std::vector<std::vector<int>> at_infinity{};
};

/// The smallest bound, less the solutions of infinite_solutions.hpp, over the references; of equal ones the first. References that would take too long are
/// left out: nothing when that is all of them, or there are none. Precondition: well posed with each
/// reference held fixed.
/// Every free point has the unknowns x ∈ C^d and s = x·x, a group of its own. s = x·x is of degree 2 in it,
/// its distance from a fixed point of degree 1, its distance from the line, s − x₁² = r², of degree 2, and
/// the distance of two free points of degree 1 in either group. So the bound has a factor 2 for every free
/// point, another 2 for each whose distance from the line is given, and counts in how many ways every other
/// distance can be given to a free end of it such that every point gets d equations, that from the line
/// included.
std::optional<BezoutBound> smallest_bezout_bound(const BoundProblem& problem);

}  // namespace gcs
