#pragma once
/// Graphs that fall apart: points hung on others, and octahedra in a chain.

#include "solvers/tests/sample_problems.hpp"

namespace gcs::samples {

struct Graph {
  int dimension = 3;
  int points = 0;
  Edges edges;
};

Graph octahedron_graph();
Graph k33_graph();

/// Hangs a point on d points of the graph.
void hang(Graph& graph, const std::vector<int>& from);
/// Hangs points on `count` random sets of d points among the first `among`, or, where that is 0, among all
/// that are there already.
void hang_at_random(Graph& graph, int count, int among, RandomNumbers& random);
/// Both graphs with the points `shared` of the one also those of the other.
Graph glued(Graph graph, const Graph& other, const std::vector<int>& shared);
/// Both graphs with the points `facet` of the one also `other_facet` of the other: in both pairwise joined.
Graph glued_at(Graph graph, const std::vector<int>& facet, const Graph& other,
               const std::vector<int>& other_facet);
/// All sets of d points that are pairwise joined.
std::vector<std::vector<int>> facets(const Graph& graph);
/// Two of the graph, each with d points in common with a simplex of d + 1 points between them. `facet`: d
/// points of the graph, pairwise joined.
Graph with_simplex_between(const Graph& graph, const std::vector<int>& facet);
/// The same graph with its points and edges in another order.
Graph relabelled(Graph graph, RandomNumbers& random);
/// Octahedra, each with a triangle in common with the next.
Graph chain_of_octahedra(int count);

/// Sketch and target lengths are those of two random placements.
ProblemStatement placed_at_random(const Graph& graph, RandomNumbers& random);

}  // namespace gcs::samples
