#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include "solvers/counting/laman_graphs.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

Answer solved(const ProblemStatement& problem, const OptionMap& options = {}) {
  return solve(Scene(problem), "monodromy", options, {.certify = true});
}

ProblemStatement with_unit_lengths(int points, const Edges& edges) {
  return problem_of(2, points, edges, std::vector<double>(edges.size(), 1));
}

/// The largest error of a squared length, by the lengths and the figure alone.
double largest_error(const ProblemStatement& problem, const Figure& figure) {
  const ComplexPoints points = complex_points(figure);
  double error = 0;
  for (const DistanceConstraint& constraint : problem.constraints)
    error = std::max(error, std::abs(squared_distance(points, constraint.between[0], constraint.between[1]) -
                                     constraint.length() * constraint.length()));
  return error;
}

/// By how much the direction from one point to another turns in the plane along the figures.
double turn_of(const FigureCurve& curve, int from, int to) {
  const auto angle = [&](const Figure& figure) {
    const Eigen::Vector3d direction = figure.points.col(to) - figure.points.col(from);
    return std::atan2(direction.y(), direction.x());
  };
  double turn = 0;
  for (std::size_t i = 1; i < curve.figures.size(); ++i)
    turn += std::remainder(angle(curve.figures[i]) - angle(curve.figures[i - 1]), 2 * std::numbers::pi);
  return turn;
}

void check_curve(const ProblemStatement& problem, const FigureCurve& curve) {
  REQUIRE(curve.figures.size() > 32);
  CHECK(curve.residual < 1e-12);
  for (const Figure& figure : curve.figures) CHECK(largest_error(problem, figure) < 1e-12);
  for (std::size_t i = 1; i < curve.figures.size(); ++i)
    CHECK((curve.figures[i].points - curve.figures[i - 1].points).norm() < 0.5 * Scene(problem).size());
}

constexpr const char* corners[] = {"A", "a", "B", "b", "C", "c"};

/// An octahedron whose opposite corners are A and a, B and b, C and c, with the exact distances that points at these places
/// have. Coordinates are multiples of 1/8.
Problem octahedron_at(const std::array<Eigen::Vector3d, 6>& places) {
  Problem p(3);
  p.points("A", "a", "B", "b", "C", "c");
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i + 1; j < 6; ++j)
      if (i / 2 != j / 2) p.squared_distance(corners[i], corners[j], (places[i] - places[j]).squaredNorm());
  return p;
}

Eigen::Vector3d half_turned(const Eigen::Vector3d& p) { return {-p.x(), -p.y(), p.z()}; }

/// Two points a, b at distance 1 from x, y and z, of which x and y are at distance 1: where a = b, z goes round them.
/// Otherwise a and b are the two points next to x and y, at a distance of √3, and z is x or y.
const Edges five_points{{0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}};

/// Two regular triangles, corresponding corners at distance 1.
const Edges prism{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};

}  // namespace

TEST_CASE("where two points coincide the rest moves, beside isolated solutions") {
  const ProblemStatement problem = with_unit_lengths(5, five_points);
  for (const char* reduce : {"on", "off"}) {
    INFO(reduce);
    const Answer answer = solved(problem, {{"reduce", reduce}});
    CHECK(answer.status == RunStatus::infinite);
    CHECK_THAT(answer.reason, Catch::Contains("a curve where p1 = p2"));
    REQUIRE(answer.motions.size() == 1);
    const Motion& motion = answer.motions[0];
    CHECK(motion.coincident == std::vector<std::array<int, 2>>{{0, 1}});
    CHECK(motion.dimension == 1);
    CHECK(motion.is_exact);
    CHECK(motion.figure.is_real());
    CHECK(largest_error(problem, motion.figure) < 1e-12);
    CHECK(motion.is_proven);
    check_curve(problem, motion.curve);
    CHECK(motion.curve.end == PathRecord::End::closed);
    CHECK(std::abs(turn_of(motion.curve, 0, 4)) == Approx(2 * std::numbers::pi));  // all of z's circle, once
    for (const Figure& figure : motion.curve.figures)
      CHECK((figure.points.col(0) - figure.points.col(1)).norm() < 1e-12);
    REQUIRE(answer.solutions.size() == 2);
    std::set<int> on;  // the one of x and y that z is at
    for (const AssessedSolution& solution : answer.solutions) {
      CHECK(solution.certified);
      CHECK((solution.point("p1") - solution.point("p2")).norm() == Approx(std::sqrt(3.0)));
      for (const int other : {3, 4})
        if ((solution.point("p5") - solution.point("p" + std::to_string(other))).norm() < 1e-12)
          on.insert(other);
    }
    CHECK(on == std::set<int>{3, 4});
    CHECK(answer.failed_checks.empty());
  }
}

TEST_CASE("a prism of regular triangles with equal bars moves as a parallelogram does") {
  const ProblemStatement problem = with_unit_lengths(6, prism);
  const Answer answer = solved(problem);
  CHECK(answer.status == RunStatus::infinite);
  REQUIRE_FALSE(answer.motions.empty());
  for (const Motion& motion : answer.motions) {
    CHECK(motion.coincident.empty());
    CHECK_FALSE(motion.parallel.empty());
    CHECK(motion.dimension == 1);
    CHECK(motion.is_exact);
    CHECK(motion.figure.is_real());
    CHECK(largest_error(problem, motion.figure) < 1e-12);
    check_curve(problem, motion.curve);
    CHECK(motion.curve.end == PathRecord::End::closed);
    CHECK(std::abs(turn_of(motion.curve, 0, 3)) ==
          Approx(2 * std::numbers::pi));  // a parallelogram's crank, once round
  }
  // Elsewhere the second triangle is the first one turned by ±120 degrees about its centre, or its image by a reflection at
  // one of the three lines that all corners are equally far from (√3/4) and a glide of ±1/2 along it.
  CHECK(answer.solutions.size() == 8);
  for (const AssessedSolution& solution : answer.solutions) CHECK((solution.certified && solution.is_real()));
}

TEST_CASE("a prism that nearly moves has only isolated solutions") {
  ProblemStatement problem = with_unit_lengths(6, prism);
  problem.constraints[6].given = {1.001, "1.001"};
  const Answer answer = solved(problem);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.motions.empty());
  CHECK_FALSE(answer.solutions.empty());
  for (const AssessedSolution& solution : answer.solutions) CHECK(solution.certified);
}

TEST_CASE("Bricard's octahedra of both symmetric types seem to move, and those beside them do not") {
  const Eigen::Vector3d a(3, 1, 2), b(1, -2, 0.5), c(-0.75, 1.5, -1);
  const auto mirrored = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.x(), p.y(), p.z()); };
  // Type 1: opposite corners are images by a half-turn. Type 2: two pairs by a plane that has the other corners.
  const std::array line_symmetric{a, half_turned(a), b, half_turned(b), c, half_turned(c)};
  const std::array plane_symmetric{
      a, mirrored(a), b, mirrored(b), Eigen::Vector3d(0, 2.5, 1), Eigen::Vector3d(0, -1, 3)};
  for (const auto& places : {line_symmetric, plane_symmetric}) {
    const Scene scene = octahedron_at(places);
    const Answer answer = solve(scene, "monodromy");
    INFO(answer.reason);
    CHECK(answer.status == RunStatus::partial);
    CHECK_THAT(answer.reason, Catch::Contains("it seems to move"));
    REQUIRE(answer.motions.size() == 1);
    const Motion& motion = answer.motions[0];
    CHECK_FALSE(motion.is_proven);
    REQUIRE(motion.curve.figures.size() > 32);
    std::set<long> diagonals;  // in tenths: they change, so that it does not only turn
    for (const Figure& figure : motion.curve.figures) {
      CHECK(largest_error(scene.problem(), figure) < 1e-10);
      diagonals.insert(std::lround(10 * (figure.points.col(0) - figure.points.col(1)).norm()));
    }
    CHECK(diagonals.size() > 3);

    auto beside = places;
    beside[0].x() += 0.125;
    const Answer rigid = solve(Scene(octahedron_at(beside)), "monodromy");
    INFO(rigid.reason);
    CHECK(rigid.motions.empty());
    CHECK(rigid.status == RunStatus::complete);
  }
}

TEST_CASE("Dixon's mechanism of the first kind seems to move as the closed form says") {
  // Points on the x-axis at x_i with x_i² = a_i + s, on the y-axis at y_j with y_j² = b_j − s: |p_i − q_j|² = a_i + b_j.
  const std::array<double, 3> a{1, 4, 9}, b{2, 5, 8};
  Problem p(2);
  p.points("p1", "p2", "p3", "q1", "q2", "q3");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      p.squared_distance("p" + std::to_string(i + 1), "q" + std::to_string(j + 1), a[i] + b[j]);
  const Scene scene = p;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SolveSettings settings;
    settings.seed = seed;
    const Answer answer = solve(scene, "monodromy", {}, settings);
    INFO("seed " << seed << ": " << answer.reason);
    CHECK(answer.status == RunStatus::partial);
    CHECK_THAT(answer.reason, Catch::Contains("it seems to move"));
    REQUIRE(answer.motions.size() == 1);
    for (const Figure& figure : answer.motions[0].curve.figures) {
      const Eigen::Vector3d across = figure.points.col(1) - figure.points.col(0),
                            along = figure.points.col(4) - figure.points.col(3);
      CHECK(largest_error(scene.problem(), figure) < 1e-10);
      CHECK(std::abs(across.dot(along)) < 1e-9);
    }
  }
}

TEST_CASE("no minimally rigid graph of up to six points has unexplained ends where the Jacobian loses rank") {
  int infinite = 0, graphs = 0;
  for (const int points : {4, 5, 6})
    for (const Edges& edges : all_laman_graphs(points)) {
      const ProblemStatement problem = with_unit_lengths(points, edges);
      const Answer answer = solved(problem);
      ++graphs;
      INFO("points " << points << ", graph " << graphs << ": " << answer.reason);
      CHECK_THAT(answer.reason, !Catch::Contains("loses rank"));
      CHECK((answer.status == RunStatus::infinite) ==
            std::ranges::any_of(answer.motions, &Motion::is_proven));
      infinite += answer.status == RunStatus::infinite;
      for (const Motion& motion : answer.motions) CHECK(largest_error(problem, motion.figure) < 1e-10);
    }
  CHECK(graphs == 1 + 3 + 13);  // OEIS A227117
  CHECK(infinite > 0);
}

// Bars along which steps without pivots lose digits, points that lie between two that they hang on, and loops that lead back
// to half of the solutions.
TEST_CASE(
    "graphs with unit lengths are settled whose paths end beside solutions, or are found by few loops") {
  const Edges found_by_halves{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 2},
                              {1, 3}, {1, 5}, {2, 4}, {3, 6}, {4, 6}};
  const Edges twice_flat{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 6},
                         {2, 4}, {2, 7}, {3, 5}, {3, 6}, {4, 5}, {5, 7}};
  const Edges in_space{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 2}, {1, 3}, {1, 4}, {1, 6},
                       {2, 3}, {2, 5}, {2, 7}, {3, 6}, {3, 7}, {4, 5}, {4, 6}, {5, 7}, {6, 7}};
  for (const auto& [dimension, points, edges] :
       {std::tuple(2, 7, found_by_halves), std::tuple(2, 8, twice_flat), std::tuple(3, 8, in_space)}) {
    const Answer answer = solve(
        Scene(problem_of(dimension, points, edges, std::vector<double>(edges.size(), 1))), "monodromy", {});
    INFO(answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    // As many as at generic lengths: in the plane every point after the first triangle has two sides, in space the m-Bézout
    // bound says so.
    std::int64_t classes = 0;
    for (const AssessedSolution& solution : answer.solutions) classes += solution.multiplicity;
    CHECK(classes == (dimension == 2 ? 1 << (points - 3) : 32));
  }
  const Edges lost_conjugate{{0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 2}, {1, 3}, {1, 6},
                             {1, 7}, {2, 3}, {4, 5}, {4, 6}, {5, 7}, {6, 7}};
  const Answer moving = solve(Scene(with_unit_lengths(8, lost_conjugate)), "monodromy", {});
  CHECK(moving.status == RunStatus::infinite);
  CHECK_THAT(moving.reason, !Catch::Contains("missing"));
  CHECK(moving.failed_checks.empty());
  for (const AssessedSolution& solution : moving.solutions) CHECK(solution.is_real());
}

TEST_CASE(
    "a platform on equal legs seems to move along a circle where it is like its base, and not beside that") {
  for (const double height : {2.0, 2.5}) {
    Problem p(2);
    p.body("base", {{"a1", {0, 0}}, {"a2", {3, 0}}, {"a3", {1, 2}}});
    p.body("platform", {{"b1", {0, 0}}, {"b2", {3, 0}}, {"b3", {1, height}}});
    p.distance("a1", "b1", 2).distance("a2", "b2", 2).distance("a3", "b3", 2);
    const Answer answer = solve(Scene(p), "monodromy", {});
    INFO(answer.reason);
    if (height != 2) {
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.motions.empty());
      CHECK(answer.solutions.size() == 6);  // Hunt 1983
      continue;
    }
    CHECK(answer.status == RunStatus::partial);
    CHECK_THAT(answer.reason, Catch::Contains("it seems to move"));
    REQUIRE(answer.motions.size() == 1);
    CHECK_FALSE(answer.motions[0].is_proven);
    CHECK(answer.motions[0].curve.figures.size() > 32);
    for (const Figure& figure : answer.motions[0].curve.figures) {
      const Eigen::Matrix3Xd legs = figure.points.rightCols(3) - figure.points.leftCols(3);
      CHECK(legs.col(0).norm() == Approx(2));
      CHECK((legs.colwise() - legs.col(0)).norm() < 1e-9);  // a translation
    }
  }
}
