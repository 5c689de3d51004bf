#pragma once
/// The minimally rigid graphs of the plane.

#include <cstdint>
#include <vector>

#include "solvers/counting/realisation_count.hpp"

namespace gcs {

inline constexpr int most_coded_points = 11;  ///< whose pairs have a bit each in 64

/// The graph whose upper triangle of the adjacency matrix, row by row, is that binary number: the code of Capco et al.
/// (2018). Precondition: at most 2 more points than most_coded_points, if the first pairs are not joined.
GraphEdges graph_of_code(int points, std::uint64_t code);

/// The smallest code that the graph has under any names of its points: equal for isomorphic graphs, and for these
/// alone. Precondition: 2 to most_coded_points points.
std::uint64_t smallest_code(int points, const GraphEdges& edges);

/// One graph of every class of isomorphic ones, by their smallest codes: Henneberg's steps from an edge make them all
/// (Laman 1970). Precondition: 2 to most_coded_points points; nine take a second, ten half a minute.
std::vector<GraphEdges> all_laman_graphs(int points);

}  // namespace gcs
