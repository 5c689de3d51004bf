#pragma once
/// How many complex solutions a problem has at generic lengths, without solving it: exactly
/// (realisation_count.hpp), or at most (bezout_bound.hpp, ring_bound.hpp, general_bound.hpp). No lengths whatever leave
/// more isolated ones.

#include <optional>
#include <vector>

#include "solvers/counting/count_bound.hpp"
#include "solvers/counting/recursion_limits.hpp"
#include "solvers/elements/element_order.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// Precondition: the problem is well posed (see analyse_structure). Takes seconds at most, with the default limits.
/// Where d points, pairwise at given distances, separate the points, the counts of the parts are multiplied.
/// Exact: points in the plane, some given perhaps, if the core is small enough, and points in space of which all but three can be
/// placed one by one. Bound, the smaller of the two, the m-Bézout bound if they are equal: points, some given perhaps, or
/// points and one line, and nothing fixed; lines at four distances on anything that has a limit or is given, by 12 each.
/// With orientations mirror images count apart.
TheoreticalCounts theoretical_counts(const ProblemStatement& problem, const RecursionLimits& limits = {});
/// `parts`: of decompose(problem, Split::all). Precondition: not a general scene.
TheoreticalCounts theoretical_counts(const ProblemStatement& problem, const std::vector<Part>& parts,
                                     const RecursionLimits& limits = {});
/// `order`: of element_order. Precondition: a general scene.
TheoreticalCounts theoretical_counts(const ProblemStatement& problem,
                                     const std::optional<ElementOrder>& order);

}  // namespace gcs
