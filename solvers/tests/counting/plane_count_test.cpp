/// [C] is Capco, Gallet, Grasegger, Koutschan, Lubbes, Schicho: The number of realizations of a Laman graph,
/// 2018.

#include "solvers/counting/plane_count.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "solvers/counting/bigraph_count.hpp"
#include "solvers/tests/laman_graphs.hpp"

using namespace gcs;

namespace {

constexpr std::int64_t plenty = 1'000'000;

Bigraph doubled(const GraphEdges& edges) {
  Bigraph bigraph;
  for (const auto& [a, b] : edges) {
    const std::array ends{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
    bigraph.push_back({{ends, ends}});
  }
  return bigraph;
}

/// [C] Theorem 4.7 as it is printed: all subsets, no memory, nothing simplified.
std::uint64_t lam_as_printed(const Bigraph& bigraph) {
  const EdgeSet all = all_edges(bigraph);
  for (const Biedge& edge : bigraph)
    for (const auto& ends : edge.ends)
      if (ends[0] == ends[1]) return 0;
  if (rank(bigraph, 0, all) + rank(bigraph, 1, all) != static_cast<int>(bigraph.size()) + 1) return 0;
  if (bigraph.size() == 1) return 1;
  std::uint64_t sum = lam_as_printed(contracted(bigraph, 0, 1)) + lam_as_printed(contracted(bigraph, 1, 1));
  for (EdgeSet m = 3; m < all; m += 2) {
    const std::uint64_t first = lam_as_printed(contracted(bigraph, 0, m));
    if (first != 0) sum += first * lam_as_printed(contracted(bigraph, 1, (all & ~m) | 1));
  }
  return sum;
}

std::uint64_t lam(const Bigraph& bigraph) { return BigraphCounter(plenty).count(bigraph).value(); }

Natural count(const GraphEdges& edges) { return count_in_plane(edges, plenty).value(); }

GraphEdges relabelled(GraphEdges edges, samples::RandomNumbers& random) {
  std::vector<int> name(edges.size());
  std::iota(name.begin(), name.end(), 0);
  const auto shuffle = [&](auto& items) {
    for (int i = static_cast<int>(items.size()); i > 1; --i) std::swap(items[i - 1], items[random.index(i)]);
  };
  shuffle(name);
  shuffle(edges);
  for (auto& edge : edges) edge = {name[edge[1]], name[edge[0]]};
  return edges;
}

}  // namespace

// [C] §1 and table 1; 3 · 2^3 for the prism and 16 for K3,3 go back to Borcea and Streinu 2004.
TEST_CASE("realisations of small graphs in the plane") {
  CHECK(count({{0, 1}}) == Natural(1));
  CHECK(count({{0, 1}, {0, 2}, {1, 2}}) == Natural(2));
  CHECK(count({{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}}) == Natural(16));
  CHECK(count({{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}, {0, 3}, {1, 4}, {2, 5}}) == Natural(24));
}

TEST_CASE("the graphs with most realisations have as many as published") {
  for (const samples::RecordGraph& record : samples::record_graphs) {
    const GraphEdges edges = samples::decoded(record);
    REQUIRE(static_cast<int>(edges.size()) == 2 * record.points - 3);
    CHECK(count(edges) == Natural(record.realisations));
  }
}

// Numbers of graphs: OEIS A227117. Largest numbers of realisations: [C] table 1.
TEST_CASE("all Laman graphs have between 2^(n − 2) and the published largest number of realisations") {
  const std::vector<std::array<std::uint64_t, 3>> known{
      {3, 1, 2}, {4, 1, 4}, {5, 3, 8}, {6, 13, 24}, {7, 70, 56}};
  for (const auto& [points, graphs, largest] : known) {
    const auto all = samples::all_laman_graphs(static_cast<int>(points));
    CHECK(all.size() == graphs);
    std::vector<Natural> counts;
    for (const GraphEdges& edges : all) counts.push_back(count(edges));
    CHECK(*std::min_element(counts.begin(), counts.end()) ==
          Natural::power_of_two(static_cast<int>(points) - 2));
    CHECK(*std::max_element(counts.begin(), counts.end()) == Natural(largest));
  }
}

TEST_CASE("the recursion gives what its printed form gives") {
  for (const int points : {3, 4, 5, 6})
    for (const GraphEdges& edges : samples::all_laman_graphs(points))
      CHECK(lam(doubled(edges)) == lam_as_printed(doubled(edges)));
}

TEST_CASE("parts that share two points multiply as the recursion for the whole says") {
  int separated = 0;
  for (const GraphEdges& edges : samples::all_laman_graphs(7)) {
    if (separate(edges)) ++separated;
    CHECK(count(edges) == Natural(lam(doubled(edges))));
  }
  // Two prisms on a common edge, with it and, one of them held by the other, without it.
  GraphEdges twins{{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}, {0, 3}, {1, 4}, {2, 5},
                   {0, 6}, {1, 6}, {7, 8}, {7, 9}, {8, 9}, {0, 7}, {1, 8}, {6, 9}};
  CHECK(count(twins) == Natural(24 * 24));
  twins.erase(twins.begin());
  twins.push_back({0, 9});
  CHECK(count(twins) == Natural(lam(doubled(twins))));
  CHECK(separated > 35);
}

TEST_CASE("the number of realisations does not depend on names and orders") {
  samples::RandomNumbers random(2018);
  for (int i = 0; i < 20; ++i) {
    const GraphEdges edges = samples::random_rigid_graph(2, 9, random);
    CHECK(count(relabelled(edges, random)) == count(edges));
  }
}

TEST_CASE("a recursion that would take too long gives up") {
  CHECK_FALSE(count_in_plane(samples::dodecagon_edges(), 100));
  CHECK(count_in_plane(samples::dodecagon_edges(), plenty) == Natural(6180));
}
