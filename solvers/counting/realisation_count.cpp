/// Two shared vertices u, v. In a Laman graph exactly one part is a Laman graph by itself, or both are when
/// uv is an edge, because 2n − 3 edges of n vertices leave 2n_A − 3 and 2n_B − 3 less one together; the other
/// is one with uv added. At generic lengths every realisation of the first part gives |uv|² a generic value
/// (lengths and placements determine each other up to finitely many choices), and with each the second has
/// its full number: the numbers multiply. A vertex of degree 2 is the simplest case, with a triangle: 2. The same
/// holds on the sphere, whose motions have as many freedoms.

#include "solvers/counting/realisation_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "solvers/counting/bigraph_count.hpp"
#include "solvers/counting/cross_ratio_count.hpp"

namespace gcs {
namespace {

using Edge = std::array<int, 2>;

int vertex_count(const GraphEdges& edges) {
  int count = 0;
  for (const Edge& edge : edges) count = std::max({count, edge[0] + 1, edge[1] + 1});
  return count;
}

std::vector<std::vector<int>> neighbours(const GraphEdges& edges) {
  std::vector<std::vector<int>> result(static_cast<std::size_t>(vertex_count(edges)));
  for (const auto& [a, b] : edges) {
    result[a].push_back(b);
    result[b].push_back(a);
  }
  return result;
}

/// What can be reached in a graph without some of its vertices.
class Reach {
 public:
  Reach(const std::vector<std::vector<int>>& neighbours, const std::vector<int>& without)
      : neighbours_(neighbours), seen_(neighbours.size(), false) {
    for (const int vertex : without) seen_[vertex] = true;
  }

  /// The vertices that hang together with the first one that is left.
  std::vector<bool> first_component() {
    std::vector<bool> component(seen_.size(), false);
    std::vector<int> open{first_left()};
    seen_[open.front()] = true;
    while (!open.empty()) {
      const int vertex = open.back();
      open.pop_back();
      component[vertex] = true;
      for (const int next : neighbours_[vertex]) {
        if (!seen_[next]) open.push_back(next);
        seen_[next] = true;
      }
    }
    return component;
  }

 private:
  int first_left() const {
    return static_cast<int>(std::find(seen_.begin(), seen_.end(), false) - seen_.begin());
  }

  const std::vector<std::vector<int>>& neighbours_;
  std::vector<bool> seen_;
};

/// A vertex without which the graph without `removed` falls apart (Hopcroft and Tarjan 1973: a child in the
/// depth-first tree that cannot reach above the vertex); −1 when there is none.
class ArticulationSearch {
 public:
  ArticulationSearch(const std::vector<std::vector<int>>& neighbours, int removed)
      : neighbours_(neighbours), order_(neighbours.size(), 0), removed_(removed) {}

  int run() {
    root_ = removed_ == 0 ? 1 : 0;
    visit(root_, -1);
    return found_;
  }

 private:
  /// Returns the lowest order that the tree below the vertex reaches with one edge.
  int visit(int vertex, int parent) {
    order_[vertex] = ++visited_;
    int low = order_[vertex], children = 0;
    for (const int next : neighbours_[vertex]) {
      if (next == removed_ || next == parent) continue;
      if (order_[next] != 0) {
        low = std::min(low, order_[next]);
        continue;
      }
      const int reached = visit(next, vertex);
      low = std::min(low, reached);
      ++children;
      if (vertex == root_ ? children > 1 : reached >= order_[vertex]) found_ = vertex;
    }
    return low;
  }

  const std::vector<std::vector<int>>& neighbours_;
  std::vector<int> order_;
  int removed_;
  int root_ = 0;
  int visited_ = 0;
  int found_ = -1;
};

Separation parts_at(const GraphEdges& edges, const std::vector<std::vector<int>>& neighbours, Edge shared) {
  const auto component = Reach(neighbours, {shared[0], shared[1]}).first_component();
  Separation separation{shared, {}};
  const auto is_shared = [&](int vertex) { return vertex == shared[0] || vertex == shared[1]; };
  for (const Edge& edge : edges) {
    const bool joins_shared = is_shared(edge[0]) && is_shared(edge[1]);
    const bool in_first = component[edge[0]] || component[edge[1]];
    if (joins_shared || in_first) separation.parts[0].push_back(edge);
    if (joins_shared || !in_first) separation.parts[1].push_back(edge);
  }
  return separation;
}

/// The same graph with vertices 0, 1, … without gaps.
GraphEdges renumbered(GraphEdges edges) {
  std::map<int, int> number;
  for (Edge& edge : edges)
    for (int& vertex : edge) vertex = number.emplace(vertex, static_cast<int>(number.size())).first->second;
  return edges;
}

bool is_laman_count(const GraphEdges& edges) {
  return static_cast<int>(edges.size()) == 2 * vertex_count(edges) - 3;
}

/// The two parts as Laman graphs.
std::array<GraphEdges, 2> laman_parts(Separation separation) {
  for (GraphEdges& part : separation.parts) {
    if (!is_laman_count(renumbered(part))) part.push_back(separation.shared);
    part = renumbered(std::move(part));
  }
  return std::move(separation.parts);
}

std::optional<Natural> natural(std::optional<std::uint64_t> number) {
  return number ? std::optional<Natural>(*number) : std::nullopt;
}

std::optional<Natural> count_by_bigraphs(const GraphEdges& edges, BigraphCounter& counter) {
  if (edges.size() > most_biedges) return std::nullopt;
  Bigraph bigraph;
  for (const Edge& edge : edges) {
    const std::array ends{static_cast<std::uint8_t>(edge[0]), static_cast<std::uint8_t>(edge[1])};
    bigraph.push_back({{ends, ends}});
  }
  return natural(counter.count(bigraph));
}

std::optional<Natural> count_by_cross_ratios(const GraphEdges& edges, CrossRatioCounter& counter) {
  constexpr MarkSet pair = 3;
  CrossRatios ratios{2 * vertex_count(edges), {}};
  if (ratios.marks > most_marks) return std::nullopt;
  for (const auto& [a, b] : edges) ratios.quadruples.push_back(pair << 2 * a | pair << 2 * b);
  return natural(counter.count(ratios));
}

/// The product of what `count` gives for the 3-connected parts.
template <typename Count>
std::optional<Natural> product_over_parts(const GraphEdges& edges, Count count) {
  Natural product = 1;
  std::vector<GraphEdges> open{renumbered(edges)};
  while (!open.empty()) {
    const GraphEdges graph = std::move(open.back());
    open.pop_back();
    if (auto separation = separate(graph)) {
      for (GraphEdges& part : laman_parts(std::move(*separation))) open.push_back(std::move(part));
      continue;
    }
    const std::optional<Natural> of_part = count(graph);
    if (!of_part) return std::nullopt;
    product = product * *of_part;
  }
  return product;
}

}  // namespace

std::optional<Separation> separate(const GraphEdges& edges) {
  const auto adjacency = neighbours(edges);
  const int vertices = static_cast<int>(adjacency.size());
  for (int removed = 0; vertices > 3 && removed < vertices; ++removed) {
    const int articulation = ArticulationSearch(adjacency, removed).run();
    if (articulation >= 0) return parts_at(edges, adjacency, {removed, articulation});
  }
  return std::nullopt;
}

std::optional<Natural> count_in_plane(const GraphEdges& edges, const RecursionLimits& limits) {
  BigraphCounter counter(limits);
  return product_over_parts(edges, [&](const GraphEdges& part) { return count_by_bigraphs(part, counter); });
}

std::optional<Natural> count_on_sphere(const GraphEdges& edges, const RecursionLimits& limits) {
  CrossRatioCounter counter(limits);
  return product_over_parts(edges,
                            [&](const GraphEdges& part) { return count_by_cross_ratios(part, counter); });
}

std::string why_given_up(std::string_view over, std::size_t points, const RecursionLimits& limits) {
  return fmt::format("The core of {} points is too large: the recursion over {} {}.", points, over,
                     limits.stop.stop_requested()
                         ? std::string("was stopped")
                         : fmt::format("takes more than the {} steps that it is given", limits.steps));
}

}  // namespace gcs
