#pragma once
/// The number of realisations of a graph in the plane at generic lengths.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/numeric/natural.hpp"

namespace gcs {

/// Vertices are numbered by small integers from 0; no loops, no double edges.
using GraphEdges = std::vector<std::array<int, 2>>;

/// A graph in two parts with two vertices in common.
struct Separation {
  std::array<int, 2> shared{};
  /// Each with an edge between the shared vertices only where the graph has it.
  std::array<GraphEdges, 2> parts;
};

/// A pair of vertices without which the graph falls apart, and two parts that this leaves; nothing for a
/// graph that is 3-connected or has less than four vertices. Precondition: it is 2-connected.
std::optional<Separation> separate(const GraphEdges& edges);

/// Placements of a Laman graph in C² with one edge held fixed, mirror images counted apart (`fixed frame`).
/// Nothing where a 3-connected part is larger than 64 edges or where the bigraph recursion takes more than
/// `most_steps` steps in all.
std::optional<Natural> count_in_plane(const GraphEdges& edges, std::int64_t most_steps);

}  // namespace gcs
