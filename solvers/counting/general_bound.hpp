#pragma once
/// Of scenes of lines, planes, bodies and angles: how many solutions there are at most, by theorems on scenes of their kind
/// and by the product of what is placed one after the other.

#include <functional>
#include <optional>
#include <vector>

#include "solvers/counting/count_bound.hpp"
#include "solvers/elements/element_order.hpp"

namespace gcs {

/// Of each entity, whether it is a line at given distances from four points: nothing else hangs on it then.
std::vector<bool> hung_lines(const ProblemStatement& problem);

/// How the numbers of a core, a problem of its own, are found.
using CountsOf = std::function<TheoreticalCounts(const ProblemStatement&)>;

/// Precondition: a general scene; `order` of element_order.
TheoreticalCounts general_counts(const ProblemStatement& problem, const std::optional<ElementOrder>& order,
                                 const CountsOf& counts_of);

}  // namespace gcs
