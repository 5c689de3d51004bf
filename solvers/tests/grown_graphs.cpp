#include "solvers/tests/grown_graphs.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace gcs::samples {
namespace {

Edges edges_of(const ProblemStatement& problem) {
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

Graph glued_at(Graph graph, const std::vector<int>& facet, const Graph& other,
               const std::vector<int>& other_facet) {
  std::vector<int> number(static_cast<std::size_t>(other.points), -1);
  for (std::size_t i = 0; i < facet.size(); ++i) number[other_facet[i]] = facet[i];
  const std::vector<int> shared = number;
  for (int& point : number)
    if (point < 0) point = graph.points++;
  for (const auto& [a, b] : other.edges)
    if (shared[a] < 0 || shared[b] < 0) graph.edges.push_back({number[a], number[b]});
  return graph;
}

Graph with_simplex_between(const Graph& graph, const std::vector<int>& facet) {
  Graph both = graph;
  std::vector<int> other_side = facet;
  other_side.front() = both.points;
  hang(both, facet);
  return glued_at(both, other_side, graph, facet);
}

std::vector<std::vector<int>> facets(const Graph& graph) {
  std::set<std::array<int, 2>> edges;
  for (const auto& [a, b] : graph.edges) edges.insert({std::min(a, b), std::max(a, b)});
  std::vector<std::vector<int>> found;
  for (const auto& [a, b] : edges) {
    if (graph.dimension == 2) found.push_back({a, b});
    for (int c = b + 1; graph.dimension == 3 && c < graph.points; ++c)
      if (edges.count({a, c}) > 0 && edges.count({b, c}) > 0) found.push_back({a, b, c});
  }
  return found;
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

ProblemStatement placed_at_random(const Graph& graph, RandomNumbers& random) {
  const Eigen::Matrix3Xd sketch = random.points(graph.dimension, graph.points, 1);
  return between(graph.dimension, graph.edges, sketch, random.points(graph.dimension, graph.points, 1));
}

}  // namespace gcs::samples
