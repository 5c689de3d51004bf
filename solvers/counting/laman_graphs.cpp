#include "solvers/counting/laman_graphs.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

/// The bit of a pair of points: the last pair has the lowest.
std::uint64_t pair_bit(int points, int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  const int pairs = points * (points - 1) / 2, before = low * (2 * points - low - 1) / 2 + high - low - 1;
  return single_bit(static_cast<std::size_t>(pairs - 1 - before));
}

/// The smallest code over all orders of the points that colour refinement leaves: what it cannot tell apart is put first
/// in turn, each with all others refined against it.
class SmallestCode {
 public:
  SmallestCode(int points, const GraphEdges& edges) : points_(points), edges_(edges) {}

  std::uint64_t run() {
    search(PointColours(static_cast<std::size_t>(points_), 1));
    return smallest_;
  }

 private:
  using PointColours = std::vector<std::uint64_t>;

  PointColours refined(PointColours colours) const {
    for (int round = 0; round < points_; ++round) {
      PointColours next = colours;
      for (const auto& [a, b] : edges_) {
        next[a] += mixed_bits(colours[b]);
        next[b] += mixed_bits(colours[a]);
      }
      for (std::uint64_t& colour : next) colour = mixed_bits(colour);
      colours = std::move(next);
    }
    return colours;
  }

  std::uint64_t code_in(const std::vector<int>& order) const {
    std::vector<int> name(order.size());
    for (int i = 0; i < points_; ++i) name[order[i]] = i;
    std::uint64_t code = 0;
    for (const auto& [a, b] : edges_) code |= pair_bit(points_, name[a], name[b]);
    return code;
  }

  void search(PointColours given) {
    const PointColours colours = refined(std::move(given));
    std::vector<int> order(colours.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return colours[a] < colours[b]; });
    const auto twins = std::adjacent_find(order.begin(), order.end(),
                                          [&](int a, int b) { return colours[a] == colours[b]; });
    if (twins == order.end()) {
      smallest_ = std::min(smallest_, code_in(order));
      return;
    }
    const std::uint64_t colour = colours[*twins];
    for (int point = 0; point < points_; ++point) {
      if (colours[point] != colour) continue;
      PointColours with_first = colours;
      with_first[point] = mixed_bits(colour + 1);
      search(std::move(with_first));
    }
  }

  int points_;
  const GraphEdges& edges_;
  std::uint64_t smallest_ = ~std::uint64_t{0};
};

/// All graphs with a point more that one of Henneberg's steps makes.
std::vector<GraphEdges> extensions(int points, const GraphEdges& edges) {
  std::vector<GraphEdges> result;
  const auto extend = [&](GraphEdges longer, const std::vector<int>& others) {
    for (const int other : others) longer.push_back({other, points});
    result.push_back(std::move(longer));
  };
  for (int a = 0; a < points; ++a)
    for (int b = a + 1; b < points; ++b) extend(edges, {a, b});
  for (std::size_t e = 0; e < edges.size(); ++e) {
    GraphEdges rest = edges;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(e));
    for (int c = 0; c < points; ++c)
      if (c != edges[e][0] && c != edges[e][1]) extend(rest, {edges[e][0], edges[e][1], c});
  }
  return result;
}

}  // namespace

GraphEdges graph_of_code(int points, std::uint64_t code) {
  GraphEdges edges;
  for (int a = points - 2; a >= 0; --a)
    for (int b = points - 1; b > a; --b, code >>= 1)
      if ((code & 1) != 0) edges.push_back({a, b});
  return edges;
}

std::uint64_t smallest_code(int points, const GraphEdges& edges) { return SmallestCode(points, edges).run(); }

std::vector<GraphEdges> all_laman_graphs(int points) {
  std::vector<GraphEdges> graphs{{{0, 1}}};
  for (int size = 2; size < points; ++size) {
    std::set<std::uint64_t> codes;
    for (const GraphEdges& graph : graphs)
      for (const GraphEdges& longer : extensions(size, graph)) codes.insert(smallest_code(size + 1, longer));
    graphs.clear();
    for (const std::uint64_t code : codes) graphs.push_back(graph_of_code(size + 1, code));
  }
  return graphs;
}

}  // namespace gcs
