/// [C] is Capco, Gallet, Grasegger, Koutschan, Lubbes, Schicho: The number of realizations of a Laman graph,
/// 2018.

#include "solvers/counting/realisation_count.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>
#include <stdexcept>

#include "solvers/counting/bigraph_count.hpp"
#include "solvers/counting/laman_graphs.hpp"
#include "solvers/counting/simplified_bigraph.hpp"
#include "solvers/counting/split_search.hpp"
#include "solvers/counting/two_forests.hpp"
#include "solvers/tests/laman_graphs.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

const RecursionLimits plenty;

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

/// By its definition.
bool has_independent_subsets(const Bigraph& bigraph) {
  for (EdgeSet edges = 1; edges <= all_edges(bigraph); ++edges)
    if (rank(bigraph, 0, edges) + rank(bigraph, 1, edges) < std::popcount(edges) + 1) return false;
  return true;
}

bool has_loop(const Bigraph& bigraph) {
  return std::any_of(bigraph.begin(), bigraph.end(), [](const Biedge& edge) {
    return edge.ends[0][0] == edge.ends[0][1] || edge.ends[1][0] == edge.ends[1][1];
  });
}

bool can_count(const Bigraph& bigraph) {
  const EdgeSet all = all_edges(bigraph);
  return bigraph.empty() || (!has_loop(bigraph) && rank(bigraph, 0, all) + rank(bigraph, 1, all) ==
                                                       static_cast<int>(bigraph.size()) + 1);
}

/// All M with e in it, of which N is the complement and e.
std::vector<EdgeParts> all_splits(const Bigraph& bigraph, EdgeSet shared) {
  const EdgeSet all = all_edges(bigraph);
  std::vector<EdgeParts> splits;
  for (EdgeSet m = 0; m <= all; ++m)
    if ((m & shared) != 0 && can_count(contracted(bigraph, 0, m)) &&
        can_count(contracted(bigraph, 1, (all & ~m) | shared)))
      splits.push_back({m, (all & ~m) | shared});
  return splits;
}

/// Edges between few vertices at random, none of them a loop.
Bigraph random_bigraph(int edges, int vertices, samples::RandomNumbers& random) {
  const auto ends = [&] {
    const int a = random.index(vertices), b = random.index(vertices - 1);
    return std::array{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b < a ? b : b + 1)};
  };
  Bigraph bigraph;
  for (int e = 0; e < edges; ++e) {
    const auto first = ends();
    bigraph.push_back({{first, ends()}});
  }
  return bigraph;
}

/// The vertices of a triangle.
std::array<int, 3> triangle_in(const GraphEdges& edges) {
  std::set<std::array<int, 2>> joined;
  for (const auto& [a, b] : edges) joined.insert({std::min(a, b), std::max(a, b)});
  for (const auto& [a, b] : joined)
    for (int c = b + 1; c <= 2 * static_cast<int>(edges.size()); ++c)
      if (joined.count({a, c}) != 0 && joined.count({b, c}) != 0) return {a, b, c};
  throw std::logic_error("the graph has no triangle");
}

/// Two graphs on a triangle of both. With the triangle's place each has half of its placements, whatever the other has.
GraphEdges on_a_triangle(const GraphEdges& first, const GraphEdges& second) {
  constexpr int apart = 32;
  const auto kept = triangle_in(first), replaced = triangle_in(second);
  const auto name = [&](int vertex) {
    const auto found = std::find(replaced.begin(), replaced.end(), vertex);
    return found == replaced.end() ? vertex + apart
                                   : kept[static_cast<std::size_t>(found - replaced.begin())];
  };
  const auto is_replaced = [&](int vertex) {
    return std::find(replaced.begin(), replaced.end(), vertex) != replaced.end();
  };
  GraphEdges glued = first;
  for (const auto& [a, b] : second)
    if (!is_replaced(a) || !is_replaced(b)) glued.push_back({name(a), name(b)});
  return glued;
}

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
    const GraphEdges edges = graph_of_code(record.points, record.code);
    REQUIRE(static_cast<int>(edges.size()) == 2 * record.points - 3);
    CHECK(count(edges) == Natural(record.realisations));
  }
}

// Numbers of graphs: OEIS A227117. Largest numbers of realisations: [C] table 1.
TEST_CASE("all Laman graphs have between 2^(n − 2) and the published largest number of realisations") {
  const std::vector<std::array<std::uint64_t, 3>> known{{3, 1, 2},   {4, 1, 4},   {5, 3, 8},
                                                        {6, 13, 24}, {7, 70, 56}, {8, 608, 136}};
  for (const auto& [points, graphs, largest] : known) {
    const auto all = all_laman_graphs(static_cast<int>(points));
    CHECK(all.size() == graphs);
    std::vector<Natural> counts;
    for (const GraphEdges& edges : all) counts.push_back(count(edges));
    CHECK(*std::min_element(counts.begin(), counts.end()) ==
          Natural::power_of_two(static_cast<int>(points) - 2));
    CHECK(*std::max_element(counts.begin(), counts.end()) == Natural(largest));
  }
}

TEST_CASE("the recursion gives what its printed form gives") {
  for (const int points : {3, 4, 5, 6, 7})
    for (const GraphEdges& edges : all_laman_graphs(points))
      CHECK(lam(doubled(edges)) == lam_as_printed(doubled(edges)));
}

TEST_CASE("edges are independent when all their subsets have rank enough") {
  samples::RandomNumbers random(1977);
  int independent = 0;
  for (int i = 0; i < 300; ++i) {
    const Bigraph bigraph = random_bigraph(7, 5, random);
    const bool expected = has_independent_subsets(bigraph);
    CHECK(is_independent(bigraph) == expected);
    independent += expected;
  }
  CHECK(independent > 30);
  CHECK(independent < 270);
}

TEST_CASE("nothing is left out of a bigraph that changes its number") {
  samples::RandomNumbers random(2018);
  int counted = 0;
  for (int i = 0; i < 300; ++i) {
    const Bigraph bigraph = random_bigraph(7, 5, random);
    const std::uint64_t number = lam_as_printed(bigraph);
    CHECK(simplified(bigraph).has_value() == (number > 0));
    CHECK(lam(bigraph) == number);
    counted += number > 1;
  }
  CHECK(counted > 20);
}

TEST_CASE("all splits that can count are found, and each once") {
  std::size_t superfluous = 0;
  for (const GraphEdges& edges : all_laman_graphs(7)) {
    const Bigraph bigraph = doubled(edges);
    StepsLeft steps(plenty);
    std::vector<EdgeParts> found = possible_splits(bigraph, steps);
    REQUIRE_FALSE(found.empty());
    std::vector<EdgeParts> expected = all_splits(bigraph, found[0][0] & found[0][1]);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    CHECK(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    CHECK(std::adjacent_find(found.begin(), found.end()) == found.end());
    superfluous += found.size() - expected.size();
  }
  CHECK(superfluous < 70);  // of some hundred
}

// 2 · (880 / 2) · (2288 / 2).
TEST_CASE("graphs on a common triangle multiply, at eighteen points") {
  const auto record = [](int points) {
    const auto& graph = samples::record_graphs.at(static_cast<std::size_t>(points - 6));
    return graph_of_code(graph.points, graph.code);
  };
  CHECK(count(on_a_triangle(record(6), record(7))) == Natural(2 * 12 * 28));
  CHECK(count(on_a_triangle(record(10), record(11))) == Natural(1006720));
}

TEST_CASE("parts that share two points multiply as the recursion for the whole says") {
  int separated = 0;
  for (const GraphEdges& edges : all_laman_graphs(7)) {
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
  CHECK_FALSE(count_in_plane(samples::dodecagon_edges(), {.steps = 100}));
  CHECK_THAT(why_given_up("bigraphs", 12, {.steps = 100}), Catch::Contains("100 steps"));
  std::stop_source stop;
  CHECK(count_in_plane(samples::dodecagon_edges(), {.stop = stop.get_token()}) == Natural(6180));
  stop.request_stop();
  CHECK_FALSE(count_in_plane(samples::dodecagon_edges(), {.stop = stop.get_token()}));
  CHECK_FALSE(count_on_sphere(samples::dodecagon_edges(), {.stop = stop.get_token()}));
  CHECK_THAT(why_given_up("bigraphs", 12, {.stop = stop.get_token()}), Catch::Contains("stopped"));
  CHECK(count_in_plane(samples::dodecagon_edges(), plenty) == Natural(6180));
}
