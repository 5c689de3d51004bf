#pragma once
/// The number of orientations of a graph with given outdegrees: the coefficient that the multihomogeneous
/// Bézout theorem takes of a product with a linear factor per edge.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/numeric/natural.hpp"

namespace gcs {

/// Every edge leaves one of its ends; vertex v is left by outdegrees[v] edges. Vertices are worked off one by
/// one, and states are the outdegrees that are left to the vertices met so far: their number grows with how
/// widely the graph hangs together, not with its size. Takes the states that it makes from `states_left`, and
/// gives nothing where they do not suffice. Ends are below outdegrees.size().
std::optional<Natural> count_orientations(const std::vector<std::array<int, 2>>& edges,
                                          const std::vector<int>& outdegrees, std::int64_t& states_left);

}  // namespace gcs
