#include "solvers/tests/grown_graphs.hpp"

#include <algorithm>
#include <numeric>
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

Graph with_simplex_between(const Graph& graph, const std::vector<int>& facet) {
  Graph both = graph;
  const int apex = both.points;
  hang(both, facet);
  std::vector<int> number(static_cast<std::size_t>(graph.points), -1);
  for (const int point : facet) number[point] = point == facet.front() ? apex : point;
  const std::vector<int> shared = number;
  for (int& point : number)
    if (point < 0) point = both.points++;
  for (const auto& [a, b] : graph.edges)
    if (shared[a] < 0 || shared[b] < 0) both.edges.push_back({number[a], number[b]});
  return both;
}

Graph relabelled(Graph graph, RandomNumbers& random) {
  std::vector<int> number(static_cast<std::size_t>(graph.points));
  std::iota(number.begin(), number.end(), 0);
  for (int i = graph.points - 1; i > 0; --i) std::swap(number[i], number[random.index(i + 1)]);
  for (auto& edge : graph.edges) edge = {number[edge[0]], number[edge[1]]};
  for (int i = static_cast<int>(graph.edges.size()) - 1; i > 0; --i)
    std::swap(graph.edges[i], graph.edges[random.index(i + 1)]);
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
