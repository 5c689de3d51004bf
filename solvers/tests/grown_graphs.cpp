#include "solvers/tests/grown_graphs.hpp"

#include <algorithm>
#include <set>

namespace gcs::samples {
namespace {

Edges edges_of(const Problem& problem) {
  Edges edges;
  for (const DistanceConstraint& constraint : problem.constraints) edges.push_back(constraint.between);
  return edges;
}

}  // namespace

Graph octahedron_graph() { return {3, 6, edges_of(octahedron())}; }
Graph k33_graph() { return {2, 6, edges_of(k33())}; }

void hang(Graph& graph, const std::vector<int>& from) {
  for (const int point : from) graph.edges.push_back({point, graph.points});
  ++graph.points;
}

void hang_at_random(Graph& graph, int count, int among, RandomNumbers& random) {
  for (int i = 0; i < count; ++i) {
    std::set<int> from;
    while (static_cast<int>(from.size()) < graph.dimension)
      from.insert(random.index(among > 0 ? among : graph.points));
    hang(graph, {from.begin(), from.end()});
  }
}

Graph glued(Graph graph, const Graph& other, const std::vector<int>& shared) {
  std::vector<int> number;
  for (int point = 0; point < other.points; ++point) {
    const bool is_shared = std::find(shared.begin(), shared.end(), point) != shared.end();
    number.push_back(is_shared ? point : graph.points++);
  }
  for (const auto& [a, b] : other.edges)
    if (number[a] != a || number[b] != b) graph.edges.push_back({number[a], number[b]});
  return graph;
}

/// Triangles 3k, 3k + 1, 3k + 2, each joined to the next by the six edges of an octahedron.
Graph chain_of_octahedra(int count) {
  Graph graph{3, 3 * (count + 1), {}};
  for (int first = 0; first < graph.points; first += 3)
    for (int i = 0; i < 3; ++i) {
      graph.edges.push_back({first + i, first + (i + 1) % 3});
      for (int j = 0; first > 0 && j < 3; ++j)
        if (i != j) graph.edges.push_back({first - 3 + i, first + j});
    }
  return graph;
}

Problem placed_at_random(const Graph& graph, RandomNumbers& random) {
  const Eigen::Matrix3Xd sketch = random.points(graph.dimension, graph.points, 1);
  return between(graph.dimension, graph.edges, sketch, random.points(graph.dimension, graph.points, 1));
}

}  // namespace gcs::samples
