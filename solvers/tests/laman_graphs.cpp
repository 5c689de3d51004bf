#include "solvers/tests/laman_graphs.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace gcs::samples {
namespace {

/// A bit per pair of points: the upper triangle of the adjacency matrix.
using PairSet = std::uint32_t;

PairSet pair_bit(int points, int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return PairSet{1} << (low * (2 * points - low - 1) / 2 + high - low - 1);
}

/// The smallest of the sets that renaming the points gives.
PairSet smallest_form(const Edges& edges, int points) {
  std::vector<int> name(static_cast<std::size_t>(points));
  std::iota(name.begin(), name.end(), 0);
  PairSet smallest = ~PairSet{0};
  do {
    PairSet set = 0;
    for (const auto& [a, b] : edges) set |= pair_bit(points, name[a], name[b]);
    smallest = std::min(smallest, set);
  } while (std::next_permutation(name.begin(), name.end()));
  return smallest;
}

/// All graphs with a point more that one step makes.
std::vector<Edges> extensions(const Edges& edges, int points) {
  std::vector<Edges> result;
  const auto extend = [&](Edges longer, const std::vector<int>& others) {
    for (const int other : others) longer.push_back({other, points});
    result.push_back(std::move(longer));
  };
  for (int a = 0; a < points; ++a)
    for (int b = a + 1; b < points; ++b) extend(edges, {a, b});
  for (std::size_t e = 0; e < edges.size(); ++e) {
    Edges without = edges;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(e));
    for (int c = 0; c < points; ++c)
      if (c != edges[e][0] && c != edges[e][1]) extend(without, {edges[e][0], edges[e][1], c});
  }
  return result;
}

}  // namespace

std::vector<Edges> all_laman_graphs(int points) {
  std::vector<Edges> graphs{{{0, 1}}};
  for (int size = 2; size < points; ++size) {
    std::vector<Edges> larger;
    std::set<PairSet> seen;
    for (const Edges& graph : graphs)
      for (Edges& longer : extensions(graph, size))
        if (seen.insert(smallest_form(longer, size + 1)).second) larger.push_back(std::move(longer));
    graphs = std::move(larger);
  }
  return graphs;
}

const std::vector<RecordGraph> record_graphs{{6, 7916, 24},
                                             {7, 1269995, 56},
                                             {8, 170989214, 136},
                                             {9, 11177989553, 344},
                                             {10, 4778440734593, 880},
                                             {11, 18120782205838348, 2288},
                                             {12, 252590061719913632, 6180}};

Edges decoded(const RecordGraph& graph) {
  Edges edges;
  std::uint64_t rest = graph.code;  // the last pair is the lowest bit
  for (int a = graph.points - 2; a >= 0; --a)
    for (int b = graph.points - 1; b > a; --b, rest >>= 1)
      if ((rest & 1) != 0) edges.push_back({a, b});
  return edges;
}

}  // namespace gcs::samples
