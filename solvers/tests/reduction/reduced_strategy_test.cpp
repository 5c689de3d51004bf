/// With reduce=on a strategy finds what it finds with reduce=off, at the cost of the parts.

#include "solvers/reduction/reduced_strategy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/reduction/simplex_coordinates.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/structure/decomposition.hpp"
#include "solvers/tests/grown_graphs.hpp"

using namespace gcs;
using samples::Graph;
using samples::RandomNumbers;

namespace {

const StrategyEntry& entry_of(std::string_view name) {
  for (const StrategyEntry& entry : all_strategies())
    if (entry.name == name) return entry;
  throw std::invalid_argument("no such strategy");
}

SolveReport solve(std::string_view name, const Scene& scene, const char* reduce,
                  std::optional<std::size_t> most_listed = std::nullopt) {
  const StrategyEntry& entry = entry_of(name);
  const auto strategy = entry.make(complete_options(entry, {{"reduce", reduce}}));
  const SolveRequest request(scene, {.most_listed = most_listed});
  strategy->prepare(request);
  return strategy->solve(request);
}

std::vector<Figure> figures_of(const Scene& scene, const SolveReport& report) {
  std::vector<Figure> figures;
  for (const Candidate& candidate : report.candidates)
    figures.push_back(scene.representative(candidate.figure));
  return figures;
}

ReflectionClasses classes_of(const Scene& scene, const std::vector<Figure>& figures) {
  std::vector<SolutionAccuracy> accuracies;
  for (const Figure& figure : figures) accuracies.push_back({jacobian_condition(scene, figure)});
  return solution_classes(scene, figures, accuracies);
}

std::size_t real_ones(const SolveReport& report) {
  return static_cast<std::size_t>(std::count_if(report.candidates.begin(), report.candidates.end(),
                                                [](const Candidate& c) { return c.figure.is_real(); }));
}

/// The same classes, each once, and as many as the totals say.
void check_agreement(std::string_view name, const Scene& scene) {
  const SolveReport whole = solve(name, scene, "off"), reduced = solve(name, scene, "on");
  INFO(name << ": " << whole.reason << " / " << reduced.reason);
  REQUIRE(whole.status == SolveStatus::complete);
  REQUIRE(reduced.status == SolveStatus::complete);
  REQUIRE(reduced.totals);
  CHECK(reduced.claim == whole.claim);
  CHECK(reduced.totals->real == Natural(real_ones(reduced)));
  if (whole.claim == Claim::all_complex) CHECK(reduced.totals->complex == Natural(reduced.candidates.size()));
  std::vector<Figure> figures = figures_of(scene, whole);
  const std::size_t wholes = figures.size();
  const int classes = classes_of(scene, figures).count();
  CHECK(reduced.candidates.size() == static_cast<std::size_t>(classes));
  const std::vector<Figure> others = figures_of(scene, reduced);
  CHECK(classes_of(scene, others).count() == static_cast<int>(others.size()));
  figures.insert(figures.end(), others.begin(), others.end());
  CHECK(classes_of(scene, figures).count() == classes);
  CHECK(real_ones(reduced) ==
        static_cast<std::size_t>(
            classes_of(scene,
                       [&] {
                         std::vector<Figure> real(figures.begin(),
                                                  figures.begin() + static_cast<std::ptrdiff_t>(wholes));
                         std::erase_if(real, [](const Figure& figure) { return !figure.is_real(); });
                         return real;
                       }())
                .count()));
}

std::int64_t steps(const SolveReport& report) { return report.work.iterations + report.work.rejected_steps; }

}  // namespace

TEST_CASE("put together, the parts have the solutions of the whole") {
  RandomNumbers random(11);
  for (int trial = 0; trial < 4; ++trial) {
    Graph octahedron = samples::octahedron_graph(), k33 = samples::k33_graph();
    samples::hang_at_random(octahedron, 2, 0, random);
    samples::hang_at_random(k33, 3, 0, random);
    for (const Graph& graph : {octahedron, k33, samples::chain_of_octahedra(2)}) {
      const Scene scene(samples::placed_at_random(graph, random));
      check_agreement("monodromy", scene);
      if (trial < 2) check_agreement("plan-scan", scene);
    }
  }
}

TEST_CASE("what is on both sides of a simplex is put together by it, whatever the order") {
  RandomNumbers random(13);
  const auto [a, b] = samples::k33_graph().edges.front();
  const Graph plane = samples::with_simplex_between(samples::k33_graph(), {a, b});
  const Graph space = samples::with_simplex_between(samples::chain_of_octahedra(1), {0, 1, 2});
  for (int trial = 0; trial < 4; ++trial)
    check_agreement("monodromy",
                    Scene(samples::placed_at_random(samples::relabelled(plane, random), random)));
  check_agreement("monodromy", Scene(samples::placed_at_random(samples::relabelled(space, random), random)));
}

TEST_CASE("scenes grown at random have the same solutions in parts and whole") {
  RandomNumbers random(14);
  for (int trial = 0; trial < 12; ++trial) {
    const Graph core = trial % 2 == 0 ? samples::k33_graph() : samples::octahedron_graph();
    Graph graph = core;
    bool has_two_cores = false;
    while (graph.points < 10) {
      const auto facets = samples::facets(graph);
      if (has_two_cores || random.index(2) == 0) {
        samples::hang_at_random(graph, 1, 0, random);
      } else {
        graph = samples::glued_at(graph, facets[random.index(static_cast<int>(facets.size()))], core,
                                  samples::facets(core).front());
        has_two_cores = true;
      }
    }
    check_agreement("monodromy",
                    Scene(samples::placed_at_random(samples::relabelled(graph, random), random)));
  }
}

TEST_CASE("points that hang on points of several parts are placed for every choice of sides") {
  RandomNumbers random(12);
  Graph graph = samples::chain_of_octahedra(2);  // 0–2, 3–5 in common, 6–8
  samples::hang(graph, {0, 4, 7});
  samples::hang(graph, {1, 6, 9});
  check_agreement("monodromy", Scene(samples::placed_at_random(graph, random)));
}

TEST_CASE("a thousand hung points cost no step of the tracker") {
  RandomNumbers random(13);
  Graph graph = samples::octahedron_graph();
  samples::hang_at_random(graph, 1000, 6, random);
  const ProblemStatement problem = samples::placed_at_random(graph, random);
  ProblemStatement core = problem;
  core.points.resize(6);
  core.sketch->points.conservativeResize(3, 6);
  core.constraints.resize(12);
  const Scene whole(problem), bare(core);
  for (const char* name : {"monodromy", "polyhedral", "plan-scan"}) {
    const SolveReport with = solve(name, whole, "on", 5), without = solve(name, bare, "off");
    INFO(name << ": " << with.reason);
    CHECK(with.status == SolveStatus::complete);
    CHECK(with.candidates.size() == 5);
    CHECK(steps(with) == steps(without));
    CHECK(with.work.evaluations == without.work.evaluations);
    // The lengths are those of a figure, so that every point has two real places at least there.
    REQUIRE(with.totals->real);
    CHECK(*with.totals->real >= Natural::power_of_two(1000));
    for (const Candidate& candidate : with.candidates)
      CHECK(relative_residual(whole, candidate.figure) < 1e-12);
  }
}

TEST_CASE("a chain of ten octahedra is counted exactly and listed as far as asked for") {
  RandomNumbers random(14);
  const Scene scene(samples::placed_at_random(samples::chain_of_octahedra(10), random));
  const SolveReport report = solve("monodromy", scene, "on", 40);
  REQUIRE(report.status == SolveStatus::complete);
  // An octahedron has 8 classes at generic lengths, each of the ten two sides, and half are mirror images.
  CHECK(report.totals->complex == Natural::power_of_two(3 * 10 + 9));
  CHECK(report.totals->generic == report.totals->complex);
  CHECK(report.candidates.size() == 40);
  CHECK(classes_of(scene, figures_of(scene, report)).count() == 40);
  CHECK(report.paths.size() == 80);
}

TEST_CASE("more choices than can be looked at are named, not counted") {
  RandomNumbers random(15);
  Graph graph = samples::octahedron_graph();
  for (int i = 0; i < 20; ++i) samples::hang(graph, {graph.points - 1, graph.points - 3, graph.points - 5});
  const SolveReport report = solve("monodromy", Scene(samples::placed_at_random(graph, random)), "on", 3);
  CHECK(report.status == SolveStatus::partial);
  CHECK(report.reason.find("more choices") != std::string::npos);
  CHECK_FALSE(report.totals->complex);
}

TEST_CASE("on the core's path hung points stay on the sketch's side") {
  RandomNumbers random(16);
  Graph graph = samples::octahedron_graph();
  samples::hang_at_random(graph, 5, 0, random);
  std::size_t placed = 0;
  for (int trial = 0; trial < 3; ++trial) {
    const ProblemStatement problem = samples::placed_at_random(graph, random);
    const Scene scene(problem);
    for (const char* name : {"full-space", "rcp"}) {
      const SolveReport report = solve(name, scene, "on");
      INFO(name << ": " << report.reason);
      CHECK(report.claim == Claim::on_path_of_core);
      CHECK((report.status == SolveStatus::complete || report.status == SolveStatus::partial));
      if (report.status == SolveStatus::partial) CHECK(report.reason.find("real place") != std::string::npos);
      placed += report.candidates.size();
      for (const Candidate& candidate : report.candidates) {
        CHECK(relative_residual(scene, candidate.figure) < 1e-12);
        for (const Part& part : decompose(problem, Split::hung_points)) {
          if (!part.is_hung_point()) continue;
          const auto side = [&](const Figure& figure) {
            const Simplex positions = figure.points.cast<std::complex<double>>();
            return std::signbit(SimplexFrame(columns(positions, part.base))
                                    .coordinates(positions.col(part.points.front()))[2]
                                    .real());
          };
          CHECK(side(candidate.figure) == side(*scene.sketch()));
        }
      }
    }
  }
  CHECK(placed > 0);
}

TEST_CASE("the core's path has the bends of the core's constraints") {
  RandomNumbers random(18);
  Graph graph = samples::octahedron_graph();
  samples::hang_at_random(graph, 2, 0, random);
  ProblemStatement problem = samples::placed_at_random(graph, random), core = problem;
  core.points.resize(6);
  core.sketch->points.conservativeResize(3, 6);
  core.constraints.resize(12);
  core.interpolation.bends = {{3, {0.5, 0.25, 0.5}}, {7, {0.1}}};
  problem.interpolation.bends = core.interpolation.bends;
  problem.interpolation.bends->push_back({13, {0.3}});
  ProblemStatement straight = core;
  straight.interpolation.bends->clear();
  for (const char* name : {"full-space", "rcp"}) {
    const SolveReport reduced = solve(name, Scene(problem), "on"), alone = solve(name, Scene(core), "off");
    INFO(name << ": " << reduced.reason);
    CHECK(steps(reduced) == steps(alone));
    CHECK(steps(reduced) != steps(solve(name, Scene(straight), "off")));
  }
}

TEST_CASE("the number of some solutions is no total") {
  RandomNumbers random(17);
  Graph graph = samples::octahedron_graph();
  samples::hang_at_random(graph, 2, 0, random);
  const Scene scene(samples::placed_at_random(graph, random));
  const SolveReport report = solve("newton-multistart", scene, "on");
  REQUIRE(report.status == SolveStatus::complete);
  CHECK(report.claim == Claim::some_real);
  CHECK(report.candidates.size() >= 4);  // the figure of the lengths, with two sides for each hung point
  REQUIRE(report.totals);
  CHECK_FALSE(report.totals->real);
  CHECK_FALSE(report.totals->complex);
}

TEST_CASE("a flat point counts once, as a double solution") {
  // p3 off the segment p1–p2, p4 on it, and p5 and p6 hang on both.
  ProblemStatement problem =
      samples::problem_of(2, 6, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 4}, {3, 4}, {2, 5}, {3, 5}},
                          {3, 2.5, 2.5, 1, 2, 2, 2, 2.2, 1.9});
  const Scene scene(problem);
  const SolveReport report = solve("monodromy", scene, "on");
  INFO(report.reason);
  CHECK(report.status == SolveStatus::complete);
  CHECK(report.candidates.size() == 4);  // p5 and p6 are on either side
  for (const Candidate& candidate : report.candidates) CHECK(candidate.multiplicity == 2);
}

TEST_CASE("lines at four distances from given points are solved apart, and their solutions combined") {
  samples::RandomNumbers random(77);
  ProblemStatement problem;
  problem.points = {"c1", "c2", "c3", "c4"};
  const Eigen::Matrix3Xd centers = random.points(3, 4, 2);
  for (int i = 0; i < 4; ++i) problem.fixed_points.emplace_back(centers.col(i));
  for (const std::string name : {"L", "M"}) {
    const LinePosition line{random.point(3, 1), random.point(3, 1).normalized()};
    const int number = problem.entity_count();
    problem.lines.push_back(name);
    for (int i = 0; i < 4; ++i)
      problem.constraints.push_back({name + std::to_string(i),
                                     {i, number},
                                     {(centers.col(i) - line.point).cross(line.direction).norm(), ""},
                                     false});
  }
  problem.fixed_lines.resize(2);
  const Scene scene(problem);
  for (const std::string strategy : {"monodromy", "sphere-tangents"}) {
    const Answer both = gcs::solve(scene, strategy, {}, {.certify = true});
    INFO(strategy << ": " << both.reason);
    CHECK(both.status == RunStatus::complete);
    CHECK(both.failed_checks.empty());
    CHECK(both.solutions.size() == 144);
    REQUIRE(both.proofs);
    CHECK(both.proofs->classes == 144);
    CHECK(both.proofs->are_complete());
    std::uint64_t real = 1;
    for (const std::size_t kept : {0U, 1U}) {
      ProblemStatement one = problem;
      one.lines = {problem.lines[kept]};
      one.fixed_lines.resize(1);
      one.constraints.assign(problem.constraints.begin() + static_cast<std::ptrdiff_t>(4 * kept),
                             problem.constraints.begin() + static_cast<std::ptrdiff_t>(4 * kept + 4));
      for (DistanceConstraint& c : one.constraints) c.between[1] = 4;
      real *= gcs::solve(Scene(one), strategy, {}, {.certify = true}).proofs->real;
    }
    CHECK(both.proofs->real == real);
  }
}

TEST_CASE("a multiple solution of a part is its own mirror image, and stands for one") {
  // p0, p1 and p3 are on one line, so that p5 is a double place.
  Problem problem(2);
  problem.points("p0", "p1", "p2", "p3", "p4", "p5");
  problem.distance("p0", "p1", 2).distance("p2", "p3", 1).distance("p0", "p3", 2).distance("p0", "p4", 2);
  problem.distance("p2", "p4", 1).distance("p3", "p4", 2).distance("p1", "p5", 1).distance("p3", "p5", 1);
  problem.distance("p0", "p5", 1);
  for (const std::string strategy : {"plan-scan", "box-subdivision", "monodromy"}) {
    const Answer answer = gcs::solve(problem, strategy);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.solutions.size() == 1);
    CHECK(answer.failed_checks.empty());
  }
}

// p3 is the same combination of p0, p1 and p2 as in a plane, but for 1e-40 in a squared length.
TEST_CASE("a point that misses the plane of its base by nearly nothing is real on one side alone") {
  for (const auto& [square, real] : {std::pair{"34.6754492187500000000000000000000000000001", 1U},
                                     {"34.6754492187499999999999999999999999999999", 0U}})
    for (const std::string strategy : {"monodromy", "polyhedral", "plan-scan", "box-subdivision"}) {
      Problem problem(3);
      problem.points("p0", "p1", "p2", "p3").squared_distance("p0", "p1", "14.85875");
      problem.squared_distance("p0", "p2", "13.480625").squared_distance("p1", "p2", "52.288125");
      problem.squared_distance("p0", "p3", square).squared_distance("p1", "p3", "5.56982421875");
      problem.squared_distance("p2", "p3", "89.33216796875");
      const Answer answer = gcs::solve(problem, strategy);
      INFO(strategy << ", " << square << ": " << answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.counts.real_up_to_reflection == real);
      CHECK(answer.failed_checks.empty());
    }
}

// p1 divides the segment of p0 and p4, but for 1e-24 in a squared length: it is 5e-13 beside it, and all hangs on it.
TEST_CASE("a point next to its base stays where the decimals put it") {
  for (const auto& [square, real] :
       {std::pair{"0.463378906250000000000001", 4U}, {"0.463378906249999999999999", 0U}})
    for (const std::string strategy : {"monodromy", "polyhedral", "plan-scan"}) {
      Problem problem(2);
      problem.points("p0", "p1", "p2", "p3", "p4").squared_distance("p4", "p0", "29.65625");
      problem.squared_distance("p4", "p1", square).squared_distance("p0", "p1", "22.70556640625");
      problem.squared_distance("p0", "p2", "67.718125").squared_distance("p1", "p2", "18.89791015625");
      problem.squared_distance("p1", "p3", "8.11697265625").squared_distance("p2", "p3", "19.5625");
      const Answer answer = gcs::solve(problem, strategy);
      INFO(strategy << ", " << square << ": " << answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.counts.real_up_to_reflection == real);
      CHECK(answer.failed_checks.empty());
      for (const auto& solution : answer.solutions) CHECK(solution.residual <= 1e-15);
    }
}

// Doubles do not tell the places of the first two apart, whatever is put together from them.
TEST_CASE("solutions of parts that doubles do not tell apart leave the answer partial, and fail no check") {
  Problem problem(2);
  problem.points("p0", "p1", "p2", "p3", "p4").squared_distance("p3", "p1", "21.625");
  problem.squared_distance("p3", "p0", "8.4472656250000000000000000000000000000001");
  problem.squared_distance("p1", "p0", "3.041015625").squared_distance("p1", "p4", "25.625");
  problem.squared_distance("p0", "p4", "22.384765625").squared_distance("p0", "p2", "9.685390625");
  problem.squared_distance("p4", "p2", "27.5725");
  for (const std::string strategy : {"monodromy", "plan-scan"}) {
    const Answer answer = gcs::solve(problem, strategy);
    CHECK(answer.status == RunStatus::partial);
    CHECK(answer.reason == "2 of the 4 solutions are listed; doubles do not tell all apart");
    CHECK(answer.failed_checks.empty());
  }
}

// b and c are at heights ±h and ±2h over the middle of a segment of length 2, and p hangs on them. On base of length h or 3h,
// by the law of cosines, it is real if it is as far from both, and not if it is 1 from the one and 2 from the other.
TEST_CASE("a point that hangs on points nearly in one place is placed by the decimals of the file") {
  for (const auto& [square_of_b, square_of_c] :
       {std::pair{"1.0000000000000001", "1.0000000000000004"},
        {"1.00000000000000000001", "1.00000000000000000004"},
        {"1.000000000000000000000001", "1.000000000000000000000004"}})
    for (const auto& [square_from_c, real] : {std::pair{"4", std::size_t{0}}, {"1", std::size_t{4}}}) {
      Problem problem(2);
      problem.points("p", "c", "q", "b", "r")
          .squared_distance("c", "r", square_of_c)
          .squared_distance("p", "b", "1")
          .squared_distance("q", "c", square_of_c)
          .squared_distance("r", "q", "4")
          .squared_distance("b", "q", square_of_b)
          .squared_distance("p", "c", square_from_c)
          .squared_distance("b", "r", square_of_b);
      const Answer answer = gcs::solve(problem, "plan-scan");
      INFO(square_of_b << ", " << square_from_c << ": " << answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.counts.real_up_to_reflection == real);
      CHECK(answer.solutions.size() == real);
    }
}
