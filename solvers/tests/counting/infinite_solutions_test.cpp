/// The m-Bézout bound less solutions at infinity against theorems that know nothing of these, and against what loops find.

#include "solvers/counting/infinite_solutions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/realisation_count.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/homotopies/monodromy_search.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tests/grown_graphs.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;

namespace {

using samples::Edges;
using samples::Graph;

/// With each triangle held in turn.
BoundProblem in_space(const Graph& graph) {
  return {3, graph.edges, std::vector<bool>(static_cast<std::size_t>(graph.points), false),
          samples::facets(graph)};
}

Natural bound_of(const Graph& graph) { return smallest_bezout_bound(in_space(graph))->fixed_frame; }

Natural bound_of(int points, const Edges& edges) { return bound_of({3, points, edges}); }

/// Two tetrahedra with an edge in common, 1 2 and 0 3, 4 5, and a point at distances from two points of each.
const Edges two_tetrahedra{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {1, 4}, {1, 5},
                           {2, 4}, {2, 5}, {4, 5}, {6, 0}, {6, 3}, {6, 4}, {6, 5}};

/// Three points, each joined to all four of a path.
const Edges path_with_three{{0, 1}, {1, 2}, {2, 3}, {4, 0}, {4, 1}, {4, 2}, {4, 3}, {5, 0},
                            {5, 1}, {5, 2}, {5, 3}, {6, 0}, {6, 1}, {6, 2}, {6, 3}};

/// All classes that loops lead to, found without a bound.
std::size_t classes_by_loops(const ProblemStatement& problem) {
  std::mt19937_64 random(1);
  const Scene scene = Scene::unchecked(problem);
  const DistanceSystem coordinates(scene);
  const SquareSystem system = square_system(coordinates);
  const Elimination elimination = order_elimination(system, random);
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  WorkCounters work;
  MonodromyOptions options;
  options.arcs = 24;
  return search_by_monodromy(
             all_lengths(system, mirror_axes(scene, coordinates)), tracking, {std::nullopt, nullptr}, options,
             random, [] { return false; }, [](int) {}, work)
      .solutions.size();
}

}  // namespace

TEST_CASE("a point on two hinged tetrahedra has four places for each of their shapes") {
  // About the hinge it is known by its height and its distance from any point there. On a circle both depend linearly on
  // coordinates: its places are those where two conics meet. The tetrahedra have two shapes each.
  std::int64_t sets_left = 1000;
  const auto at_infinity = infinite_solutions(7, two_tetrahedra, {0, 1, 2}, sets_left);
  REQUIRE(at_infinity.size() == 1);
  CHECK(at_infinity.front().points == std::vector<int>{4, 5});
  CHECK(at_infinity.front().count == Natural(16));
  CHECK(sets_left == 1000 - 15);
  CHECK(bound_of(7, two_tetrahedra) == Natural(16));
}

TEST_CASE("three points beside a path of three bars have twelve figures") {
  // The other three distances of the path's points are zeros of three Cayley-Menger determinants, whose Newton polytopes are a
  // pyramid of volume 8/3: 16 zeros at most (Bernstein). Four of these are straight paths, which no others are beside.
  CHECK(bound_of(7, path_with_three) == Natural(2 * 12));
}

TEST_CASE("a ring with three hinges in one point has the postures of an arm with a wrist") {
  // Four places and two turns of the wrist for each shape of four tetrahedra (Pieper 1968).
  CHECK(bound_of(10, samples::edges_within(
                         {{0, 1, 2}, {0, 2, 3}, {0, 3, 4, 5}, {4, 5, 6, 7}, {6, 7, 8, 9}, {8, 9, 0, 1}})) ==
        Natural(16 * 8));
}

TEST_CASE("rings of hinged bodies have no fewer than the theorem about them says, and mostly as many") {
  // ring_bound.hpp: 2^(n − 2), which random lengths have (ring_bound_test.cpp).
  CHECK(bound_of(8, samples::disulfide_edges()) == Natural(64));
  int met = 0;
  for (unsigned pattern = 0; pattern < 64; ++pattern) {
    std::vector<bool> meets;
    for (unsigned body = 0; body < 6; ++body) meets.push_back((pattern >> body & 1U) != 0);
    const int points = 6 + static_cast<int>(std::ranges::count(meets, false));
    const Natural bound = bound_of(points, samples::hinged_ring_edges(meets));
    CHECK(bound >= Natural::power_of_two(points - 2));
    met += bound == Natural::power_of_two(points - 2) ? 1 : 0;
  }
  CHECK(met > 32);
}

TEST_CASE("cones have no fewer than there are on the sphere") {
  samples::RandomNumbers random(4);
  int met = 0;
  const int count = repetitions(20);
  for (int i = 0; i < count; ++i) {
    const Edges base = samples::random_rigid_graph(2, 6, random);
    Edges cone = base;
    for (int point = 0; point < 6; ++point) cone.push_back({6, point});
    const Natural exact = *count_on_sphere(base, {});
    CHECK(bound_of(7, cone) >= exact);
    met += bound_of(7, cone) == exact ? 1 : 0;
  }
  CHECK(met > count / 2);
}

TEST_CASE("loops find at most as many, and mostly as many, on random rigid graphs") {
  samples::RandomNumbers random(11);
  int met = 0;
  const int count = repetitions(12);
  for (int i = 0; i < count; ++i) {
    const ProblemStatement problem = samples::random_problem(3, 8, random);
    const auto counts = theoretical_counts(problem);
    REQUIRE(counts.bound);
    const Natural found(classes_by_loops(problem));
    CHECK(found <= counts.bound->count.up_to_reflection());
    met += found == counts.bound->count.up_to_reflection() ? 1 : 0;
  }
  CHECK(met > 3 * count / 4);
}

TEST_CASE("names and hung points change the bound as they should") {
  samples::RandomNumbers random(6);
  for (const Edges& edges : {two_tetrahedra, path_with_three}) {
    Graph graph{3, 7, edges};
    const Natural alone = bound_of(graph);
    CHECK(bound_of(samples::relabelled(graph, random)) == alone);
    samples::hang_at_random(graph, 3, 0, random);
    CHECK(bound_of(samples::relabelled(graph, random)) == Natural(8) * alone);
  }
}

TEST_CASE("only points in space are known to be at infinity") {
  const auto bound = [](const std::function<void(BoundProblem&)>& change) {
    BoundProblem problem = in_space({3, 7, two_tetrahedra});
    change(problem);
    return smallest_bezout_bound(problem);
  };
  CHECK(bound([](BoundProblem&) {})->at_infinity.size() == 1);
  CHECK(bound([](BoundProblem& problem) { problem.are_points = false; })->fixed_frame == Natural(32));
  // One point beside the line in the place of a distance.
  CHECK(bound([](BoundProblem& problem) {
          problem.on_line[6] = true;
          problem.edges.pop_back();
        })->at_infinity.empty());
}

TEST_CASE("sets of points that are not tried are not at infinity") {
  std::int64_t sets_left = 3;
  CHECK(infinite_solutions(7, two_tetrahedra, {0, 1, 2}, sets_left).empty());
  CHECK(sets_left == 0);
  sets_left = 1000;
  CHECK(infinite_solutions(65, two_tetrahedra, {0, 1, 2}, sets_left).empty());
  CHECK(sets_left == 1000);
}
