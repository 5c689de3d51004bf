#pragma once
/// The numbers of realisations of a graph in the plane and on the sphere at generic lengths.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/counting/recursion_limits.hpp"
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
/// Nothing where a 3-connected part is larger than 64 edges or where the recursion over bigraphs
/// (bigraph_count.hpp) exceeds the limits.
std::optional<Natural> count_in_plane(const GraphEdges& edges, const RecursionLimits& limits);

/// Likewise on the complex sphere x² + y² + z² = 1, for which the same graphs are minimally rigid. Nothing where a
/// 3-connected part is larger than 29 vertices or where the recursion over cross ratios (cross_ratio_count.hpp)
/// exceeds the limits.
std::optional<Natural> count_on_sphere(const GraphEdges& edges, const RecursionLimits& limits);

/// Why a count of a graph with so many points gave up, in a sentence. `over`: what its recursion goes over.
std::string why_given_up(std::string_view over, std::size_t points, const RecursionLimits& limits);

}  // namespace gcs
