/// The strategy cayley-menger on octahedra that are not shipped.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/tests/contract/problem_restatements.hpp"
#include "solvers/figures/reflection_classes.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const std::string& strategy = "cayley-menger",
                const OptionMap& options = {}) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

/// Edges between all of six points but (0, 3), (1, 4), (2, 5).
ProblemStatement octahedron_of(const Eigen::Matrix3Xd& points) {
  ProblemStatement problem = load_instance("octahedron").problem;
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
ProblemStatement with_hanging_point(ProblemStatement problem, std::array<int, 3> from, double unit) {
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

/// Squared distances in decimals of any number of digits, without the other constraints.
ProblemStatement squared_distances(int points,
                                   const std::vector<std::tuple<int, int, std::string>>& squares) {
  ProblemStatement problem = load_instance("octahedron").problem;
  problem.sketch.reset();
  problem.points.clear();
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  if (!problem.fixed_points.empty()) problem.fixed_points.resize(problem.points.size());
  problem.constraints.clear();
  for (const auto& [a, b, square] : squares)
    problem.constraints.push_back(
        {"d" + std::to_string(problem.constraints.size()), {a, b}, {std::stod(square), square}, true});
  return problem;
}

/// An octahedron whose Jacobian is singular to 1e-16 where |p0p5|² = 1.176916470405022644509943149310, and
/// this length a little off.
ProblemStatement near_fold(const std::string& square) {
  return squared_distances(6, {{0, 1, "1.181882508010782636501266141695"},
                               {0, 2, "3.857600416192804447826805981928"},
                               {0, 4, "7.057274285918949183333504297271"},
                               {0, 5, square},
                               {1, 2, "5.044360121841088545176053346563"},
                               {1, 3, "3.367013906010070616787063999509"},
                               {1, 5, "4.709532796517550387349871118278"},
                               {2, 3, "14.293928012260412208947681542853"},
                               {2, 4, "17.822938682958057046375954549281"},
                               {3, 4, "11.811425916351134261813188823773"},
                               {3, 5, "8.163219736373605933025295423810"},
                               {4, 5, "4.978899863579783759328895960774"}});
}

/// (0, 0, 0), (4, 0, 0), (1, 3, 0), and three more points off this plane, with a point that hangs on the
/// first three: at |p6p0|² = 5 its place is (2, 1, 0), in their plane.
ProblemStatement hanging_near_its_base(const std::string& square) {
  return squared_distances(7, {{0, 1, "16"},
                               {0, 2, "10"},
                               {0, 4, "5"},
                               {0, 5, "17"},
                               {1, 2, "18"},
                               {1, 3, "21"},
                               {1, 5, "9"},
                               {2, 3, "21"},
                               {2, 4, "5"},
                               {3, 4, "44"},
                               {3, 5, "40"},
                               {4, 5, "36"},
                               {6, 0, square},
                               {6, 1, "5"},
                               {6, 2, "5"}});
}

std::int64_t particular(const SolveRun& run, const std::string& name) {
  const auto found = std::find_if(run.particulars.begin(), run.particulars.end(),
                                  [&](const Particular& count) { return count.name == name; });
  return found == run.particulars.end() ? -1 : found->value;
}

int real_ones(const SolveRun& run) {
  const auto& solutions = run.solutions;
  return static_cast<int>(std::count_if(solutions.begin(), solutions.end(),
                                        [](const AssessedSolution& s) { return s.figure.is_real(); }));
}

/// True when the real solution `points` is among those found.
bool holds(const ProblemStatement& problem, const SolveRun& run, const Eigen::Matrix3Xd& points) {
  const Scene scene(problem);
  const double unit = std::ldexp(1.0, -scene.unit_exponent());
  return std::any_of(run.solutions.begin(), run.solutions.end(), [&](const AssessedSolution& s) {
    if (!s.figure.is_real()) return false;
    const std::array<Figure, 2> pair{s.figure, Figure{unit * points, {}, {}}};
    return reflection_classes(scene, pair, 1e-8).count() == 1;
  });
}

}  // namespace

TEST_CASE("random octahedra have eight complex classes, the one they were made of among them") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3Xd points = random_points(random);
    const ProblemStatement problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO("octahedron " << i << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 8);
    CHECK(run.failed_checks.empty());
    CHECK(run.counts.at_infinity == 0);
    CHECK(run.counts.generic == 8);
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("cayley-menger finds the classes that path tracking finds, to 1e-12") {
  const ProblemStatement problem = load_instance("octahedron").problem;
  const Scene scene(problem);
  const SolveRun all = solved(problem);
  const SolveRun path = solved(problem, "full-space");
  REQUIRE(path.solutions.size() == 4);
  REQUIRE(real_ones(all) == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Matrix3Xd difference =
        all.solutions[i].placement().points - path.solutions[i].placement().points;
    CHECK(difference.cwiseAbs().maxCoeff() <= 1e-12);
  }
}

TEST_CASE("cyclohexane has eight real classes, some with the same diagonals") {
  const SolveRun run = solved(load_instance("octahedron-cyclohexane").problem);
  CHECK(run.status == RunStatus::complete);
  CHECK(real_ones(run) == 8);
  CHECK(run.solutions.size() == 8);
}

TEST_CASE("points that hang on an octahedron are placed on both sides") {
  std::mt19937_64 random(4);
  const ProblemStatement problem = octahedron_of(random_points(random));
  const ProblemStatement more = with_hanging_point(with_hanging_point(problem, {0, 1, 2}, 2), {1, 2, 6}, 2);
  const SolveRun run = solved(more);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.solutions.size() == 32);
  for (const FailedCheck& check : run.failed_checks) FAIL_CHECK(check.name << ": " << check.what);
  CHECK(run.counts.generic == 32);
}

TEST_CASE("an edge of 1e-5 leaves all eight classes, four of them far away in its frame") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3Xd points = with_short_edge(random, 0x1p-17);
    const ProblemStatement problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO("octahedron " << i << ": " << run.reason);
    const bool is_too_far = run.reason.find("doubles do not hold the distances") != std::string::npos;
    CHECK((run.status == RunStatus::complete || is_too_far));
    CHECK(run.solutions.size() == 8);
    CHECK(run.failed_checks.empty());
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("a point that hangs on an octahedron with a short edge is placed on both sides of all classes") {
  std::mt19937_64 random(8);
  const ProblemStatement problem = octahedron_of(with_short_edge(random, 0x1p-17));
  for (const std::string reduce : {"on", "off"}) {
    const SolveRun run =
        solved(with_hanging_point(problem, {2, 3, 4}, 2), "cayley-menger", {{"reduce", reduce}});
    INFO("reduce " << reduce << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 16);
  }
}

TEST_CASE("solutions of an octahedron with a short edge scale by powers of two, bit by bit") {
  std::mt19937_64 random(8);
  const Eigen::Matrix3Xd points = with_short_edge(random, 0x1p-17);
  const SolveRun run = solved(octahedron_of(points));
  for (const double scale : {0x1p100, 0x1p-100}) {
    const SolveRun scaled = solved(octahedron_of(scale * points));
    REQUIRE(scaled.solutions.size() == run.solutions.size());
    for (std::size_t i = 0; i < run.solutions.size(); ++i) {
      const Figure at_one = run.solutions[i].placement(), at_scale = scaled.solutions[i].placement();
      CHECK(at_scale.points == scale * at_one.points);
      CHECK(at_scale.imaginary == scale * at_one.imaginary);
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
    ProblemStatement problem = octahedron_of(points);
    double& length = problem.constraints[static_cast<std::size_t>(i % 12)].given.value;
    length = std::nextafter(length, 10);
    const SolveRun run = solved(problem);
    // With each real octahedron its mirror image, by the theorem of octahedron/exact_elimination.hpp.
    for (const Particular& fact : run.particulars)
      if (run.status == RunStatus::complete && fact.name == "proven_real_solutions")
        CHECK(run.counts.real_up_to_reflection == static_cast<std::uint64_t>(fact.value / 2));
    CHECK(run.status != RunStatus::infinite);
    CHECK(run.failed_checks.empty());
    CHECK(run.reason.empty() == (run.status == RunStatus::complete));
  }
}

TEST_CASE("a pair of diagonals that escapes to infinity is counted as such") {
  // A parallelogram of four edges around: |p2p3| + |p5p6| = |p2p6| + |p3p5| sends a pair of diagonals to
  // infinity. With coordinates of a few bits opposite sides are equal to the last one.
  std::mt19937_64 random(6);
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3Xd points = (1024 * random_points(random)).array().round() / 1024;
    points.col(5) = points.col(4) + points.col(1) - points.col(2);
    const ProblemStatement problem = octahedron_of(points);
    const SolveRun run = solved(problem);
    INFO(run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.at_infinity.value_or(0) > 0);
    CHECK(run.counts.at_infinity.value_or(0) + run.solutions.size() == 8);
    CHECK(holds(problem, run, points));
  }
}

TEST_CASE("two simple solutions near a fold are no double one, and real on one side of it only") {
  // plan-scan proves 2 real classes and no other one above the singular length, and none below it; they move
  // apart with the root of the difference, a thousandth of it being some 1e-7 apart.
  for (const auto& [square, real] : {std::pair("1.176916471405022644509943149310", 2),
                                     {"1.176916470415022644509943149310", 2},
                                     {"1.176916470405122644509943149310", 2},
                                     {"1.176916470405032644509943149310", 2},
                                     {"1.176916470405012644509943149310", 0},
                                     {"1.176916470404922644509943149310", 0},
                                     {"1.176916470395022644509943149310", 0},
                                     {"1.176916469405022644509943149310", 0}}) {
    const SolveRun run = solved(near_fold(square));
    INFO(square << " " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 8);
    CHECK(real_ones(run) == real);
    CHECK(run.counts.singular == 0U);
    CHECK(run.failed_checks.empty());
  }
}

TEST_CASE("a point that hangs just beside the plane of its base is placed on both sides") {
  // The squared height over the plane is a tenth of the difference from 5 and more, of either sign: the
  // octahedron's 4 real classes have 2 real places for it each, or none.
  for (const std::string reduce : {"on", "off"})
    for (const auto& [square, real] : {std::pair("5.0000000001", 8),
                                       {"5.00000000000001", 8},
                                       {"5.000000000000001", 8},
                                       {"4.999999999999999", 0},
                                       {"4.99999999999999", 0},
                                       {"4.9999999999", 0}}) {
      const SolveRun run = solved(hanging_near_its_base(square), "cayley-menger", {{"reduce", reduce}});
      INFO(square << ", reduce " << reduce << ": " << run.reason);
      const bool is_whole = run.solutions.size() == 16 && real_ones(run) == real;
      if (reduce == "off") CHECK(run.status == RunStatus::complete);
      CHECK((is_whole || run.status == RunStatus::partial));
    }
}

TEST_CASE("a point that hangs in the plane of its base has one place of multiplicity two") {
  const SolveRun run = solved(hanging_near_its_base("5"), "cayley-menger", {{"reduce", "off"}});
  INFO(run.reason);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.solutions.size() == 8);
  CHECK(real_ones(run) == 4);
  for (const AssessedSolution& solution : run.solutions) CHECK(solution.multiplicity == 2);
}

TEST_CASE("solutions that doubles do not tell apart are not called complete") {
  // Heights of 1e-14 and less over the plane of the base.
  const SolveRun run =
      solved(hanging_near_its_base("5.0000000000000000000000000001"), "cayley-menger", {{"reduce", "off"}});
  CHECK(run.status == RunStatus::partial);
  CHECK_THAT(run.reason, Catch::Contains("too near each other to be told apart"));
}

TEST_CASE("the exact polynomial has as many real roots as two other methods find real octahedra") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 10; ++i) {
    const ProblemStatement problem = octahedron_of(random_points(random));
    const SolveRun exact = solved(problem, "cayley-menger", {{"method", "univariate"}});
    INFO("octahedron " << i << ": " << exact.reason);
    CHECK(exact.status == RunStatus::complete);
    CHECK(exact.solutions.size() == 8);
    CHECK(exact.failed_checks.empty());
    CHECK(particular(exact, "eliminated_degree") == 16);
    CHECK(particular(exact, "proven_real_solutions") == 2 * real_ones(exact));
    CHECK(real_ones(exact) == real_ones(solved(problem)));
    CHECK(real_ones(exact) == real_ones(solved(problem, "plan-scan")));
  }
}

TEST_CASE("exact elimination tells two solutions near a fold apart") {
  for (const auto& [square, real] :
       {std::pair("1.176916470405032644509943149310", 2), {"1.176916470405012644509943149310", 0}}) {
    const SolveRun run = run_strategy(find_strategy("cayley-menger"), {{"method", "univariate"}},
                                      Scene(near_fold(square)), {});
    INFO(square << " " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 8);
    CHECK(particular(run, "proven_real_solutions") == 2 * real);
  }
}

TEST_CASE("exact elimination too proves that an octahedron flexes, and counts diagonals at infinity") {
  std::mt19937_64 random(5);
  Eigen::Matrix3Xd points = (1024 * random_points(random)).array().round() / 1024;
  Eigen::Matrix3Xd turned = points;
  for (int p = 0; p < 3; ++p) turned.col(p + 3) << -points(0, p), -points(1, p), points(2, p);
  CHECK(solved(octahedron_of(turned), "cayley-menger", {{"method", "univariate"}}).status ==
        RunStatus::infinite);
  points.col(5) = points.col(4) + points.col(1) - points.col(2);
  const SolveRun run = solved(octahedron_of(points), "cayley-menger", {{"method", "univariate"}});
  CHECK(run.status == RunStatus::complete);
  CHECK(run.counts.at_infinity.value_or(0) + run.solutions.size() == 8);
}

TEST_CASE("cayley-menger says what it is not for") {
  CHECK(solved(load_instance("disulfide").problem).status == RunStatus::unsupported);
  CHECK(solved(load_instance("k33").problem).status == RunStatus::unsupported);
  CHECK(solved(load_instance("tangents-durand").problem).status == RunStatus::unsupported);
}
