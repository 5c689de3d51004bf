/// The strategy cayley-menger on octahedra that are not shipped.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "harness/instance_io.hpp"
#include "harness/solve_run.hpp"
#include "harness/strategy_choice.hpp"
#include "harness/tests/problem_restatements.hpp"
#include "solvers/model/reflection_classes.hpp"

using namespace gcs;

namespace {

SolveRun solved(const Problem& problem, const std::string& strategy = "cayley-menger",
                const OptionMap& options = {}) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

/// Edges between all of six points but (0, 3), (1, 4), (2, 5).
Problem octahedron_of(const Eigen::Matrix3Xd& points) {
  Problem problem = load_instance("octahedron").problem;
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    constraint.given = {(points.col(a) - points.col(b)).norm(), ""};
  }
  problem.sketch.reset();
  return problem;
}

Eigen::Matrix3Xd random_points(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  return Eigen::Matrix3Xd::NullaryExpr(3, 6, [&](Eigen::Index, Eigen::Index) { return coordinate(random); });
}

/// A point at distances 1, 1.1 and 1.2 (times the longest edge) from three others.
Problem with_hanging_point(Problem problem, std::array<int, 3> from, double unit) {
  const int point = static_cast<int>(problem.points.size());
  problem.points.push_back("hanging " + std::to_string(point));
  for (int i = 0; i < 3; ++i)
    problem.constraints.push_back(
        {"h" + std::to_string(3 * point + i), {point, from[i]}, {unit * (1 + 0.1 * i), ""}, false});
  if (!problem.fixed_points.empty()) problem.fixed_points.emplace_back();
  return problem;
}

/// Random places of size 1, but for the second point: so far from the first.
Eigen::Matrix3Xd with_short_edge(std::mt19937_64& random, double length) {
  Eigen::Matrix3Xd points = random_points(random);
  points.col(1) = points.col(0) + Eigen::Vector3d(length, 0, 0);
  return points;
}

int real_ones(const SolveRun& run) {
  const auto& solutions = run.assessment.solutions;
  return static_cast<int>(std::count_if(solutions.begin(), solutions.end(),
                                        [](const AssessedSolution& s) { return s.figure.is_real(); }));
}

/// True when the real solution `points` is among those found.
bool holds(const Problem& problem, const SolveRun& run, const Eigen::Matrix3Xd& points) {
  const Scene scene(problem);
  const double unit = std::ldexp(1.0, -scene.unit_exponent());
  return std::any_of(run.assessment.solutions.begin(), run.assessment.solutions.end(),
                     [&](const AssessedSolution& s) {
                       if (!s.figure.is_real()) return false;
                       const std::array<Figure, 2> pair{Figure{unit * s.figure.points, {}, {}},
                                                        Figure{unit * points, {}, {}}};
                       return reflection_classes(scene, pair, 1e-8).count() == 1;
                     });
}

}  // namespace

TEST_CASE("random octahedra have eight complex classes, the one they were made of among them") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3Xd points = random_points(random);
    const Problem problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO("octahedron " << i << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.assessment.solutions.size() == 8);
    CHECK(run.assessment.failed_checks.empty());
    CHECK(run.assessment.counts.at_infinity == 0);
    CHECK(run.assessment.counts.generic == 8);
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("cayley-menger finds the classes that path tracking finds, to 1e-12") {
  const Problem problem = load_instance("octahedron").problem;
  const Scene scene(problem);
  const SolveRun all = solved(problem);
  const SolveRun path = solved(problem, "full-space");
  REQUIRE(path.assessment.solutions.size() == 4);
  REQUIRE(real_ones(all) == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Matrix3Xd difference =
        all.assessment.solutions[i].figure.points - path.assessment.solutions[i].figure.points;
    CHECK(difference.cwiseAbs().maxCoeff() <= 1e-12);
  }
}

TEST_CASE("cyclohexane has eight real classes, some with the same diagonals") {
  const SolveRun run = solved(load_instance("octahedron-cyclohexane").problem);
  CHECK(run.status == RunStatus::complete);
  CHECK(real_ones(run) == 8);
  CHECK(run.assessment.solutions.size() == 8);
}

TEST_CASE("points that hang on an octahedron are placed on both sides") {
  std::mt19937_64 random(4);
  const Problem problem = octahedron_of(random_points(random));
  const Problem more = with_hanging_point(with_hanging_point(problem, {0, 1, 2}, 2), {1, 2, 6}, 2);
  const SolveRun run = solved(more);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.assessment.solutions.size() == 32);
  for (const FailedCheck& check : run.assessment.failed_checks) FAIL_CHECK(check.name << ": " << check.what);
  CHECK(run.assessment.counts.generic == 32);
}

TEST_CASE("an edge of 1e-5 leaves all eight classes, four of them far away in its frame") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3Xd points = with_short_edge(random, 0x1p-17);
    const Problem problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO("octahedron " << i << ": " << run.reason);
    const bool is_too_far = run.reason.find("doubles do not hold the distances") != std::string::npos;
    CHECK((run.status == RunStatus::complete || is_too_far));
    CHECK(run.assessment.solutions.size() == 8);
    CHECK(run.assessment.failed_checks.empty());
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("a point that hangs on an octahedron with a short edge is placed on both sides of all classes") {
  std::mt19937_64 random(8);
  const Problem problem = octahedron_of(with_short_edge(random, 0x1p-17));
  for (const std::string reduce : {"on", "off"}) {
    const SolveRun run =
        solved(with_hanging_point(problem, {2, 3, 4}, 2), "cayley-menger", {{"reduce", reduce}});
    INFO("reduce " << reduce << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.assessment.solutions.size() == 16);
  }
}

TEST_CASE("solutions of an octahedron with a short edge scale by powers of two, bit by bit") {
  std::mt19937_64 random(8);
  const Eigen::Matrix3Xd points = with_short_edge(random, 0x1p-17);
  const SolveRun run = solved(octahedron_of(points));
  for (const double scale : {0x1p100, 0x1p-100}) {
    const SolveRun scaled = solved(octahedron_of(scale * points));
    REQUIRE(scaled.assessment.solutions.size() == run.assessment.solutions.size());
    for (std::size_t i = 0; i < run.assessment.solutions.size(); ++i) {
      const Figure& figure = run.assessment.solutions[i].figure;
      CHECK(scaled.assessment.solutions[i].figure.points == scale * figure.points);
      CHECK(scaled.assessment.solutions[i].figure.imaginary == scale * figure.imaginary);
    }
  }
}

TEST_CASE("an octahedron that flexes is proven to") {
  // Bricard's first type: opposite points are exchanged by a half turn about an axis, so that opposite edges
  // have the same length to the last bit.
  std::mt19937_64 random(5);
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3Xd points = random_points(random);
    for (int p = 0; p < 3; ++p) points.col(p + 3) << -points(0, p), -points(1, p), points(2, p);
    const SolveRun run = solved(octahedron_of(points));
    CHECK(run.status == RunStatus::infinite);
    CHECK(run.reason.find("flexes") != std::string::npos);
  }
}

TEST_CASE("an octahedron that flexes but for the last bit of a length is not called flexible") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3Xd points = random_points(random);
    for (int p = 0; p < 3; ++p) points.col(p + 3) << -points(0, p), -points(1, p), points(2, p);
    Problem problem = octahedron_of(points);
    double& length = problem.constraints[static_cast<std::size_t>(i % 12)].given.value;
    length = std::nextafter(length, 10);
    const SolveRun run = solved(problem);
    CHECK((run.status == RunStatus::gave_up || run.status == RunStatus::partial));
    CHECK_FALSE(run.reason.empty());
  }
}

TEST_CASE("a pair of diagonals that escapes to infinity is counted as such") {
  // A parallelogram of four edges around: |p2p3| + |p5p6| = |p2p6| + |p3p5| sends a pair of diagonals to
  // infinity. With coordinates of a few bits opposite sides are equal to the last one.
  std::mt19937_64 random(6);
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3Xd points = (1024 * random_points(random)).array().round() / 1024;
    points.col(5) = points.col(4) + points.col(1) - points.col(2);
    const Problem problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO(run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.assessment.counts.at_infinity.value_or(0) > 0);
    CHECK(run.assessment.counts.at_infinity.value_or(0) + run.assessment.solutions.size() == 8);
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("cayley-menger says what it is not for") {
  CHECK(solved(load_instance("disulfide").problem).status == RunStatus::unsupported);
  CHECK(solved(load_instance("k33").problem).status == RunStatus::unsupported);
  CHECK(solved(load_instance("tangents-durand").problem).status == RunStatus::unsupported);
}
