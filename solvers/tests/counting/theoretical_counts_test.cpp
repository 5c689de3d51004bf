/// [B] is Bartzos, Emiris, Schicho: On the multihomogeneous Bézout bound on the number of embeddings of
/// minimally rigid graphs, 2020.

#include "solvers/counting/theoretical_counts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/counting/orientation_count.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::Edges;

namespace {

ProblemStatement graph(int dimension, int points, const Edges& edges) {
  return samples::problem_of(dimension, points, edges, std::vector<double>(edges.size(), 1.0));
}

std::optional<Natural> orientations(const Edges& edges, const std::vector<int>& outdegrees,
                                    std::int64_t most_states = 1'000'000) {
  return count_orientations(edges, outdegrees, most_states);
}

Natural bound(const TheoreticalCounts& counts) {
  REQUIRE(counts.bound);
  return counts.bound->count.fixed_frame;
}

Natural exact(const TheoreticalCounts& counts) {
  REQUIRE(counts.exact);
  return counts.exact->fixed_frame;
}

/// All orientations, one by one.
std::uint64_t orientations_one_by_one(const Edges& edges, const std::vector<int>& outdegrees) {
  std::uint64_t count = 0;
  for (std::uint64_t choice = 0; choice < std::uint64_t{1} << edges.size(); ++choice) {
    std::vector<int> left = outdegrees;
    for (std::size_t e = 0; e < edges.size(); ++e) --left[edges[e][choice >> e & 1]];
    if (std::count(left.begin(), left.end(), 0) == static_cast<std::ptrdiff_t>(left.size())) ++count;
  }
  return count;
}

/// Adds a point at given distances from the points named.
ProblemStatement with_hanging_point(ProblemStatement problem, const std::vector<int>& from) {
  const int point = static_cast<int>(problem.points.size());
  problem.points.push_back("hanging");
  for (const int other : from)
    problem.constraints.push_back({"h" + std::to_string(other), {other, point}, {1, "1"}, false});
  return problem;
}

/// Five points and a line, as in Hoffmann and Yuan 2000: all distances from the line, p5 joined to all, and
/// the others in a ring.
ProblemStatement pyramid_on_line() {
  ProblemStatement problem = graph(3, 5, {{0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 1}, {1, 2}, {2, 3}, {3, 0}});
  problem.lines = {"L"};
  for (int point = 0; point < 5; ++point)
    problem.constraints.push_back({"l" + std::to_string(point), {point, 5}, {1, "1"}, false});
  return problem;
}

Edges complete_bipartite(int left, int right) {
  Edges edges;
  for (int a = 0; a < left; ++a)
    for (int b = 0; b < right; ++b) edges.push_back({a, left + b});
  return edges;
}

void check_conventions(const SolutionCount& count, const char* fixed_frame, const char* up_to_reflection,
                       const char* all_signs) {
  CHECK(count.fixed_frame.decimal() == fixed_frame);
  CHECK(count.up_to_reflection().decimal() == up_to_reflection);
  CHECK(count.all_signs().decimal() == all_signs);
}

}  // namespace

TEST_CASE("with an orientation mirror images count apart, and the equations are the same") {
  const auto oriented = [](ProblemStatement problem) {
    Relation relation{"side", "orientation", {}, Relation::Form::none};
    for (int point = 0; point <= problem.dimension; ++point) relation.of.push_back({point});
    relation.sign = 1;
    problem.relations.push_back(std::move(relation));
    return theoretical_counts(problem);
  };
  check_conventions(*oriented(graph(2, 6, complete_bipartite(3, 3))).exact, "16", "16", "16");
  const TheoreticalCounts counts = oriented(samples::octahedron());
  REQUIRE(counts.bound);
  check_conventions(counts.bound->count, "16", "16", "16");
  // A line and a point leave a half-turn beside two mirrors.
  const TheoreticalCounts plain = theoretical_counts(pyramid_on_line()), beside = oriented(pyramid_on_line());
  REQUIRE(plain.bound);
  REQUIRE(beside.bound);
  CHECK(beside.bound->count.up_to_reflection() == Natural(2) * plain.bound->count.up_to_reflection());
}

TEST_CASE("orientations are counted as one by one") {
  samples::RandomNumbers random(7);
  std::uint64_t found = 0;
  for (int i = 0; i < 200; ++i) {
    const int points = 2 + random.index(5), edge_count = 1 + random.index(12);
    Edges edges;
    std::vector<int> outdegrees(static_cast<std::size_t>(points), 0);
    while (static_cast<int>(edges.size()) < edge_count) {
      const int a = random.index(points), b = random.index(points);
      if (a == b) continue;
      edges.push_back({a, b});
      ++outdegrees[random.sign() > 0 ? a : b];
    }
    if (i % 5 == 0) ++outdegrees[0];
    const std::uint64_t expected = orientations_one_by_one(edges, outdegrees);
    CHECK(orientations(edges, outdegrees) == Natural(expected));
    found += expected;
  }
  CHECK(found > 200);
}

// A ring can be turned in two ways; rings side by side in 2^k.
TEST_CASE("orientations of many rings are counted exactly") {
  Edges edges;
  for (int ring = 0; ring < 80; ++ring)
    for (int i = 0; i < 3; ++i) edges.push_back({3 * ring + i, 3 * ring + (i + 1) % 3});
  const std::vector<int> ones(240, 1);
  CHECK(orientations(edges, ones) == Natural::power_of_two(80));
  CHECK_FALSE(orientations(edges, ones, 10));
}

// [B] gives the bound 16 for the octahedron and 54272 for the icosahedron, and 15360 in the plane for the
// Laman graph with most realisations among those of 12 points. The disulfide bond is a ring of two tetrahedra
// and four triangles with six hinges: 2·2·16.
TEST_CASE("bounds of the graphs of the literature") {
  CHECK(bound(theoretical_counts(samples::octahedron())) == Natural(16));
  CHECK(bound(theoretical_counts(graph(3, 12, samples::icosahedron_edges()))) == Natural(54272));
  CHECK(bound(theoretical_counts(graph(3, 8, samples::disulfide_edges()))) == Natural(64));
  const TheoreticalCounts dodecagon = theoretical_counts(graph(2, 12, samples::dodecagon_edges()));
  CHECK(exact(dodecagon) == Natural(6180));
  CHECK(bound(dodecagon) == Natural(15360));
}

TEST_CASE("one number in three conventions") {
  check_conventions(*theoretical_counts(samples::k33()).exact, "16", "8", "32");
  check_conventions(theoretical_counts(samples::octahedron()).bound->count, "16", "8", "64");
  check_conventions(theoretical_counts(pyramid_on_line()).bound->count, "288", "72", "576");
  // With a triangle in the place of the ring: four quartics, and two ways round for the ends of distances.
  ProblemStatement no_wheel = pyramid_on_line();
  no_wheel.constraints[4].between = {0, 2};
  check_conventions(theoretical_counts(no_wheel).bound->count, "512", "128", "1024");
  // Two points, and a triangle in space, are their own mirror images.
  check_conventions(*theoretical_counts(graph(2, 2, {{0, 1}})).exact, "1", "1", "2");
  check_conventions(*theoretical_counts(graph(3, 3, {{0, 1}, {0, 2}, {1, 2}})).exact, "1", "1", "4");
  check_conventions(*theoretical_counts(graph(3, 2, {{0, 1}})).exact, "1", "1", "2");
  // So are a point and a line.
  ProblemStatement pair = graph(3, 1, {});
  pair.lines = {"L"};
  pair.constraints = {{"l", {0, 1}, {1, "1"}, false}};
  check_conventions(theoretical_counts(pair).bound->count, "1", "1", "2");
}

TEST_CASE("the count of the core never exceeds its bound") {
  samples::RandomNumbers random(11);
  for (int i = 0; i < 30; ++i) {
    const TheoreticalCounts counts =
        theoretical_counts(graph(2, 9, samples::random_rigid_graph(2, 9, random)));
    CHECK(exact(counts) <= bound(counts));
  }
}

TEST_CASE("a point that hangs on d others doubles every number") {
  const auto check_doubled = [](const SolutionCount& before, const SolutionCount& after) {
    CHECK(after.fixed_frame == before.fixed_frame * Natural(2));
    CHECK(after.up_to_reflection() == before.up_to_reflection() * Natural(2));
    CHECK(after.all_signs() == before.all_signs() * Natural(2));
  };
  const ProblemStatement plane = samples::k33(), space = samples::octahedron();
  check_doubled(*theoretical_counts(plane).exact,
                *theoretical_counts(with_hanging_point(plane, {1, 3})).exact);
  check_doubled(theoretical_counts(space).bound->count,
                theoretical_counts(with_hanging_point(space, {0, 1, 3})).bound->count);
}

TEST_CASE("a thousand points one by one have 2^1000 solutions") {
  for (const int dimension : {2, 3}) {
    Edges edges;
    for (int point = 1; point < 1000 + dimension; ++point)
      for (int other = std::max(0, point - dimension); other < point; ++other)
        edges.push_back({other, point});
    const TheoreticalCounts counts = theoretical_counts(graph(dimension, 1000 + dimension, edges));
    CHECK(exact(counts) == Natural::power_of_two(1000));
    CHECK(bound(counts) == Natural::power_of_two(1000));
    CHECK(exact(counts).decimal().size() == 302);
  }
}

// K4,6 is rigid in space and has no redundant edge (Bolker and Roth 1980).
TEST_CASE("in space a bound needs a triangle, if only of a hanging point") {
  const ProblemStatement without = graph(3, 10, complete_bipartite(4, 6));
  const TheoreticalCounts counts = theoretical_counts(without);
  CHECK_FALSE(counts.exact);
  CHECK_FALSE(counts.bound);
  CHECK_THAT(counts.why_no_bound, Catch::Contains("triangle"));
  const TheoreticalCounts hanging = theoretical_counts(with_hanging_point(without, {0, 4, 5}));
  REQUIRE(hanging.bound);
  CHECK(std::count(hanging.bound->reference.begin(), hanging.bound->reference.end(), 10) == 1);
}

TEST_CASE("what cannot be counted is refused with the reason") {
  ProblemStatement fixed = samples::octahedron();
  fixed.fixed_points.resize(fixed.points.size());
  fixed.fixed_points[0] = Eigen::Vector3d::Zero();
  CHECK_THAT(theoretical_counts(fixed).why_no_bound, Catch::Contains("fixed"));
  CHECK_THAT(theoretical_counts(fixed).why_no_exact, Catch::Contains("fixed"));
  CHECK(theoretical_counts(fixed).upper_limit() == nullptr);
  ProblemStatement lines = pyramid_on_line();
  CHECK_THAT(theoretical_counts(lines).why_no_exact, Catch::Contains("line"));
  lines.lines.emplace_back("M");
  CHECK_THAT(theoretical_counts(lines).why_no_bound, Catch::Contains("more than one line"));
}

TEST_CASE("a point on the line makes no frame with it") {
  ProblemStatement problem = pyramid_on_line();
  for (DistanceConstraint& constraint : problem.constraints)
    if (constraint.between[1] == 5) constraint.given = {0, "0"};
  CHECK_THAT(theoretical_counts(problem).why_no_bound, Catch::Contains("above 0"));
}

/// A triangle 0 1 2 on as many legs as it has freedoms, from given points 3 4 5.
ProblemStatement given_platform(int dimension) {
  Edges edges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}};
  if (dimension == 3) edges.insert(edges.end(), {{1, 3}, {2, 4}, {0, 5}});
  ProblemStatement problem = graph(dimension, 6, edges);
  problem.fixed_points.resize(6);
  problem.fixed_points[3] = {0, 0, 0};
  problem.fixed_points[4] = {5, 0.25, 0};
  problem.fixed_points[5] = {3.1, 4.7, 0};
  return problem;
}

TEST_CASE("figures around given points are counted") {
  // In the plane 6 postures of either orientation (Hunt 1983), in space 16 on legs that meet in pairs (Griffis, Duffy 1989).
  const TheoreticalCounts flat = theoretical_counts(given_platform(2));
  CHECK(exact(flat) == Natural(12));
  CHECK(flat.exact->up_to_reflection() == Natural(12));
  CHECK(bound(flat) >= Natural(12));
  CHECK(bound(theoretical_counts(given_platform(3))) == Natural(16));
}

TEST_CASE("cones in space have as many realisations as their bases on the sphere") {
  // The prism 32, K3,3 16 on the sphere: Gallet, Grasegger, Schicho 2020; in space, 32 and 16 for these cones:
  // Bartzos, Emiris, Legerský, Tsigaridas 2021.
  const auto cone = [](Edges edges, int points) {
    for (int point = 0; point < points; ++point) edges.push_back({point, points});
    return graph(3, points + 1, edges);
  };
  const Edges prism{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  CHECK(exact(theoretical_counts(cone(prism, 6))) == Natural(32));
  const ProblemStatement k33 = cone(complete_bipartite(3, 3), 6);
  CHECK(exact(theoretical_counts(k33)) == Natural(16));
  CHECK(exact(theoretical_counts(with_hanging_point(k33, {0, 1, 3}))) == Natural(32));
  // The octahedron has no apex, the tetrahedron four.
  CHECK_FALSE(theoretical_counts(samples::octahedron()).exact);
  CHECK(exact(theoretical_counts(cone({{0, 1}, {1, 2}, {2, 0}}, 3))) == Natural(2));
}
