#include "solvers/counting/ring_bound.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/tests/closed_chain.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::Edges;

namespace {

int points_of(const Edges& edges) {
  int points = 0;
  for (const auto& [a, b] : edges) points = std::max({points, a + 1, b + 1});
  return points;
}

std::vector<std::vector<int>> triangles_of(const Edges& edges) {
  std::set<std::array<int, 2>> joined;
  for (const auto& [a, b] : edges) joined.insert({std::min(a, b), std::max(a, b)});
  std::vector<std::vector<int>> triangles;
  const int points = points_of(edges);
  for (int a = 0; a < points; ++a)
    for (int b = a + 1; b < points; ++b)
      for (int c = b + 1; c < points; ++c)
        if (joined.contains({a, b}) && joined.contains({a, c}) && joined.contains({b, c}))
          triangles.push_back({a, b, c});
  return triangles;
}

std::optional<RingBound> ring_of(const Edges& edges) {
  return ring_bound(points_of(edges), edges, triangles_of(edges));
}

/// In which order six pairs of consecutive hinges meet or not, up to turning the ring.
std::vector<std::vector<bool>> hinge_patterns() {
  std::vector<std::vector<bool>> patterns;
  for (int bits = 0; bits < 64; ++bits) {
    std::vector<bool> pattern, turned;
    for (int i = 0; i < 6; ++i) pattern.push_back((bits >> i & 1) != 0);
    turned = pattern;
    bool is_first = true;
    for (int i = 0; i < 6; ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      is_first = is_first && pattern <= turned;
    }
    if (is_first) patterns.push_back(pattern);
  }
  return patterns;
}

/// The same graph with other numbers for the points and the edges in another order.
Edges relabelled(Edges edges, samples::RandomNumbers& random) {
  std::vector<int> names(static_cast<std::size_t>(points_of(edges)));
  std::iota(names.begin(), names.end(), 0);
  for (std::size_t i = names.size(); i > 1; --i)
    std::swap(names[i - 1], names[random.index(static_cast<int>(i))]);
  for (auto& edge : edges) edge = {names[edge[1]], names[edge[0]]};
  std::reverse(edges.begin(), edges.end());
  return edges;
}

Edges without(Edges edges, const std::array<int, 2>& edge) {
  const auto found = std::find(edges.begin(), edges.end(), edge);
  REQUIRE(found != edges.end());
  edges.erase(found);
  return edges;
}

Edges with(Edges edges, const std::array<int, 2>& edge) {
  edges.push_back(edge);
  return edges;
}

ProblemStatement in_space(const Edges& edges) {
  return samples::problem_of(3, points_of(edges), edges, std::vector<double>(edges.size(), 1.0));
}

const std::vector<bool> all_meet(6, true);

}  // namespace

// The shapes of the bodies, 2 of a tetrahedron, times the ways in which the ring closes, counted modulo a
// prime.
TEST_CASE("the bound of a ring is the number of its solutions, whichever hinges meet") {
  std::mt19937_64 random(5);
  const auto patterns = hinge_patterns();
  CHECK(patterns.size() == 14);  // necklaces of six beads of two colours
  for (const std::vector<bool>& meets : patterns) {
    const auto ring = ring_of(samples::hinged_ring_edges(meets));
    REQUIRE(ring);
    const auto closings = samples::count_closings(meets, random);
    REQUIRE(closings);
    const int tetrahedra = static_cast<int>(std::count(meets.begin(), meets.end(), false));
    CHECK(ring->fixed_frame ==
          Natural::power_of_two(tetrahedra) * Natural(static_cast<std::uint64_t>(*closings)));
  }
}

TEST_CASE("a ring is found however its points are numbered") {
  samples::RandomNumbers random(3);
  for (int i = 0; i < 20; ++i) {
    CHECK(ring_of(relabelled(samples::disulfide_edges(), random))->fixed_frame == Natural(64));
    CHECK(ring_of(relabelled(samples::hinged_ring_edges(all_meet), random))->fixed_frame == Natural(16));
  }
}

TEST_CASE("the bodies of a ring come in order, each sharing two points with the next") {
  const auto ring = ring_of(samples::disulfide_edges());
  REQUIRE(ring);
  REQUIRE(ring->bodies.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<int>&a = ring->bodies[i], &b = ring->bodies[(i + 1) % 6];
    CHECK(std::count_if(a.begin(), a.end(),
                        [&](int point) { return std::find(b.begin(), b.end(), point) != b.end(); }) == 2);
  }
}

TEST_CASE("other rings have no bound") {
  for (const std::size_t bodies : {4, 5, 7, 8})
    CHECK_FALSE(ring_of(samples::hinged_ring_edges(std::vector<bool>(bodies, false))));
  const Edges seven = samples::hinged_ring_edges({true, false, true, false, true, false, true});
  CHECK_FALSE(ring_of(with(seven, {0, 5})));
  CHECK_FALSE(ring_of(samples::icosahedron_edges()));
}

TEST_CASE("a ring with a distance less, more or elsewhere has no bound") {
  const Edges disulfide = samples::disulfide_edges();
  for (const auto& edge : disulfide) CHECK_FALSE(ring_of(without(disulfide, edge)));
  for (const std::array<int, 2>& across : Edges{{3, 7}, {0, 4}, {2, 6}})
    CHECK_FALSE(ring_of(with(disulfide, across)));
  for (const std::array<int, 2>& hinge : Edges{{0, 1}, {1, 2}, {2, 3}, {4, 5}, {5, 6}, {6, 7}})
    CHECK_FALSE(ring_of(with(without(disulfide, hinge), {3, 7})));
}

// An arm whose last three axes meet has 8 solutions, not 16, for each shape of the four tetrahedra (Pieper
// 1968: 4 places of the wrist, 2 turns of it).
TEST_CASE("a ring with three hinges in one point has the bound of any ring") {
  const auto ring = ring_of(
      samples::edges_within({{0, 1, 2}, {0, 2, 3}, {0, 3, 4, 5}, {4, 5, 6, 7}, {6, 7, 8, 9}, {8, 9, 0, 1}}));
  REQUIRE(ring);
  CHECK(ring->fixed_frame == Natural(16 * 16));
}

TEST_CASE("the smaller bound counts") {
  const TheoreticalCounts disulfide = theoretical_counts(in_space(samples::disulfide_edges()));
  REQUIRE(disulfide.bound);
  CHECK(disulfide.bound->ring.size() == 6);
  CHECK(disulfide.bound->count.up_to_reflection() == Natural(32));
  CHECK(disulfide.bound->reference == std::vector<int>{0, 1, 2});
  const TheoreticalCounts hanging =
      theoretical_counts(in_space(with(with(with(samples::disulfide_edges(), {8, 0}), {8, 3}), {8, 5})));
  REQUIRE(hanging.bound);
  CHECK(hanging.bound->count.up_to_reflection() == Natural(64));
  CHECK(hanging.bound->ring == disulfide.bound->ring);
  const TheoreticalCounts octahedron = theoretical_counts(samples::octahedron());
  REQUIRE(octahedron.bound);
  CHECK(octahedron.bound->count.up_to_reflection() == Natural(8));
  CHECK(octahedron.bound->ring.empty());
  CHECK(theoretical_counts(in_space(samples::icosahedron_edges())).bound->ring.empty());
}
