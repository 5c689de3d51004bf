/// The strategy sphere-tangents on shipped and on random spheres.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/tests/strategies/line_precision.hpp"
#include "harness/tests/strategies/tangent_samples.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/complex_lines.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const OptionMap& options = {}) {
  return run_strategy(find_strategy("sphere-tangents"), options, Scene::unchecked(problem), {});
}

/// The square in decimals of any number of digits.
void set_square(ProblemStatement& problem, int constraint, const std::string& square) {
  problem.constraints[static_cast<std::size_t>(constraint)].given = {std::stod(square), square};
  problem.constraints[static_cast<std::size_t>(constraint)].is_squared = true;
}

/// Spheres of which the last has this squared radius; with 5 the z-axis is a double tangent.
ProblemStatement near_double_tangent(const std::string& square) {
  Eigen::Matrix<double, 3, 4> centers;
  centers << 1, 0, -1, 2, 0, 1, 1, 1, 0, 1, 2, 0.5;
  ProblemStatement problem = spheres(centers, Eigen::Vector4d::Ones());
  for (int i = 0; i < 4; ++i) set_square(problem, i, std::array<std::string, 4>{"1", "1", "2", square}[i]);
  return problem;
}

int multiplicities(const SolveRun& run) {
  int sum = 0;
  for (const AssessedSolution& solution : run.solutions) sum += solution.multiplicity;
  return sum;
}

bool holds_conjugate(const SolveRun& run, const ComplexLine& line) {
  return std::any_of(run.solutions.begin(), run.solutions.end(), [&](const AssessedSolution& other) {
    const ComplexLine at = complex_lines(other.placement())[0];
    const auto off = [&](const Eigen::Vector3cd& u) { return (at.direction - u).norm(); };
    const Eigen::Vector3cd u = line.direction.conjugate();
    return std::min(off(u), off(-u)) <= 1e-9 * u.norm() &&
           (at.point - line.point.conjugate()).norm() <= 1e-9 * (1 + at.point.norm());
  });
}

/// Both methods find the same lines, and 24 paths have named ends of which none failed.
void expect_agreement(const ProblemStatement& problem) {
  const SolveRun direct = solved(problem), homotopy = solved(problem, {{"method", "homotopy"}});
  INFO(homotopy.reason);
  CHECK(homotopy.status == direct.status);
  CHECK(homotopy.failed_checks.empty());
  CHECK(homotopy.counts.paths == 24U);
  CHECK(homotopy.counts.failed_paths == 0U);
  CHECK(homotopy.counts.at_infinity == 2 * direct.counts.at_infinity.value());
  CHECK(have_same_lines(direct, homotopy));
}

/// To 1e-12; where the rounding of the coordinates leaves more, the exact line's.
constexpr double precise = 1e-12;

bool is_precise(const FourDistances& given, const AssessedSolution& solution) {
  const ComplexLine line = complex_lines(solution.placement())[0];
  const WideLine wide = refined_in_double_double(given, line);
  // Eight roundings of coordinates: Newton's method has left the line where it was.
  constexpr double same = 8 * 0x1p-53;
  return wide.residual <= precise && wide.moved <= same &&
         solution.residual <= std::max(precise, residual_of_rounding(given, line));
}

void expect_twelve(const ProblemStatement& problem) {
  const SolveRun run = solved(problem);
  INFO(run.reason);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.solutions.size() == 12);
  CHECK(run.failed_checks.empty());
  const FourDistances given = distances_of(problem);
  for (const AssessedSolution& solution : run.solutions) {
    CHECK(holds_conjugate(run, complex_lines(solution.placement())[0]));
    CHECK(is_precise(given, solution));
  }
}

}  // namespace

TEST_CASE("the published tangents have 12 complex lines and 4 or 12 real ones") {
  for (const auto& [id, real] :
       {std::pair("tangents-durand", 4), {"tangents-12-real", 12}, {"tangents-equal-radii", 12}}) {
    const SolveRun run = solved(load_instance(id).problem);
    INFO(id << " " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 12);
    CHECK(real_ones(run) == real);
    CHECK(run.failed_checks.empty());
  }
}

TEST_CASE("touching spheres have 3 real tangents of multiplicity 4, found to 1e-12") {
  const SolveRun run = solved(load_instance("tangents-fourfold").problem);
  CHECK(run.status == RunStatus::complete);
  REQUIRE(run.solutions.size() == 3);
  CHECK(real_ones(run) == 3);
  for (const AssessedSolution& solution : run.solutions) {
    CHECK(solution.multiplicity == 4);
    // By symmetry the lines are the axes of coordinates.
    CHECK(solution.placement().lines[0].point.norm() <= 1e-12);
    CHECK(std::abs(solution.figure.lines[0].direction.cwiseAbs().maxCoeff() - 1) <= 1e-12);
    CHECK(solution.residual <= 1e-12);
  }
}

TEST_CASE("random spheres have 12 tangents to 1e-12 or to the last bit, closed under conjugation") {
  Dice dice(12);
  for (int i = 0; i < 1000; ++i) expect_twelve(dice.problem(Eigen::Matrix3d::Identity()));
}

TEST_CASE("a line that is off by more than rounding is not precise") {
  Dice dice(18);
  const ProblemStatement problem =
      spheres(dice.centers(), {1, 0.7, 0.8, 0.6});  // the scene's unit is the file's
  const FourDistances given = distances_of(problem);
  for (AssessedSolution solution : solved(problem).solutions) {
    const bool is_real = solution.figure.is_real();
    ComplexLine line = complex_lines(solution.placement())[0];
    line.direction[0] *= 1 + 1e-10;
    solution.figure = figure_of(complex_points(solution.figure), {line}, is_real);
    solution.residual = relative_residual(Scene::unchecked(problem), solution.figure);
    CHECK(solution.residual > std::max(precise, residual_of_rounding(given, line)));
    CHECK_FALSE(is_precise(given, solution));
  }
}

TEST_CASE("coplanar and nearly coplanar centres have 12 tangents") {
  Dice dice(13);
  for (double height = 1; height > 1e-18; height /= 10)
    for (int i = 0; i < 10; ++i) {
      Eigen::Matrix<double, 3, 4> centers = dice.centers();
      centers.row(2) *= i == 0 ? 0 : height;
      expect_twelve(spheres(centers, dice.distances()));
    }
}

TEST_CASE("a line through a point is found with its multiplicity") {
  // The distance 0 is the cone of isotropic lines, at whose apex a real line is a double solution. Along
  // u = (3, 4, 0)/5 squared distances |c × u|² = z² + (3y − 4x)²/25 of whole numbers have two decimals.
  Dice dice(14);
  const Eigen::Vector3d u(0.6, 0.8, 0);
  for (int i = 0; i < 20; ++i) {
    ProblemStatement problem = spheres((9 * dice.centers()).array().round(), Eigen::Vector4d::Ones());
    const Eigen::Vector3d first = *problem.fixed_points[0];
    for (int p = 0; p < 4; ++p) {
      const Eigen::Vector3d c = *problem.fixed_points[p] - first;
      const long hundredths = std::lround(100 * c[2] * c[2] + 4 * std::pow(3 * c[1] - 4 * c[0], 2));
      set_square(problem, p, fmt::format("{}.{:02}", hundredths / 100, hundredths % 100));
    }
    const SolveRun run = solved(problem);
    INFO(run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(multiplicities(run) == 12);
    CHECK(std::any_of(run.solutions.begin(), run.solutions.end(), [&](const AssessedSolution& s) {
      return s.figure.is_real() && s.multiplicity == 2 && s.figure.lines[0].direction.cross(u).norm() <= 1e-9;
    }));
  }
}

TEST_CASE("a line through a point that only rounded distances have is no real one") {
  // Every real line at distance 0 goes through the point, and there are two unknowns for three distances. The
  // two complex ones are as near to each other as the rounding.
  Dice dice(14);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix<double, 3, 4> centers = dice.centers();
    const Eigen::Vector3d u = dice.direction();
    Eigen::Vector4d distances;
    for (int p = 0; p < 4; ++p) distances[p] = (centers.col(p) - centers.col(0)).cross(u).norm();
    const SolveRun run = solved(spheres(centers, distances));
    INFO(run.reason);
    CHECK(run.status == RunStatus::partial);
    CHECK_THAT(run.reason, Catch::Contains("too near each other"));
    CHECK(run.solutions.size() == 11);
    CHECK(real_ones(run) == 0);
  }
}

TEST_CASE("simple tangents next to each other are no double one, whatever the method") {
  // plan-scan proves 4 real lines below the singular square 5 of the fourth distance and 2 above it; of the
  // first two of these 1e-14 leaves 1e-7.
  for (const auto& [square, real] : {std::pair("5.000000000001", 2),
                                     {"5.0000000000001", 2},
                                     {"5.00000000000001", 2},
                                     {"4.99999999999999", 4},
                                     {"4.9999999999999", 4},
                                     {"4.999999999999", 4}})
    for (const std::string method : {"direct", "homotopy"}) {
      const SolveRun run = solved(near_double_tangent(square), {{"method", method}});
      INFO(square << " " << method << ": " << run.reason);
      CHECK(run.status == RunStatus::complete);
      CHECK(run.solutions.size() == 12);
      CHECK(real_ones(run) == real);
      CHECK(run.failed_checks.empty());
    }
}

TEST_CASE("a tangent that the decimals make double is listed as such") {
  for (const std::string method : {"direct", "homotopy"}) {
    const SolveRun run = solved(near_double_tangent("5"), {{"method", method}});
    INFO(method << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 11);
    CHECK(real_ones(run) == 3);
    CHECK(multiplicities(run) == 12);
  }
}

TEST_CASE("spheres that nearly touch have twelve real tangents, near to each other by fours") {
  // By symmetry and scaling: with the square 2 + ε for one of the four radii the fourfold lines part by the
  // root of ε, all of them into real ones where ε > 0.
  for (const std::string square : {"2.0000000001", "2.000000000001", "2.0000000000001"})
    for (const std::string method : {"direct", "homotopy"}) {
      ProblemStatement problem = load_instance("tangents-fourfold").problem;
      set_square(problem, 0, square);
      const SolveRun run = solved(problem, {{"method", method}});
      INFO(square << " " << method << ": " << run.reason);
      CHECK(run.failed_checks.empty());
      const bool is_whole = run.solutions.size() == 12 && real_ones(run) == 12;
      CHECK((is_whole || run.status == RunStatus::partial));
      if (square.size() > 12) CHECK(run.status == RunStatus::complete);
    }
}

TEST_CASE("centres on two parallel lines send tangents to infinity") {
  // An isotropic direction u across the two lines has c·u = 0 on one of them and constant on the other, so
  // that the distances are those of a line at infinity; of a parallelogram both pairs of sides do so.
  Eigen::Matrix<double, 3, 4> centers;
  centers << 0, 0, 2, 2, 0, 0, 0, 0, 0, 1, 0, 3;
  const SolveRun trapezium = solved(spheres(centers, {1, 0.9, 0.8, 0.95}));
  CHECK(trapezium.status == RunStatus::complete);
  CHECK(trapezium.counts.at_infinity == 2);
  expect_agreement(spheres(centers, {1, 0.9, 0.8, 0.95}));
  centers.row(2) << 0, 1, 0.3, 1.3;
  const SolveRun parallelogram = solved(spheres(centers, {1, 0.9, 0.8, 0.95}));
  CHECK(parallelogram.status == RunStatus::complete);
  CHECK(parallelogram.counts.at_infinity == 4);
  expect_agreement(spheres(centers, {1, 0.9, 0.8, 0.95}));
}

TEST_CASE("the 24 paths lead to the lines that the direct method finds") {
  for (const std::string id :
       {"tangents-durand", "tangents-12-real", "tangents-equal-radii", "tangents-fourfold"})
    expect_agreement(load_instance(id).problem);
  Dice dice(16);
  for (int i = 0; i < 100; ++i) {
    Eigen::Matrix<double, 3, 4> centers = dice.centers();
    if (i % 10 == 0) centers.row(2).setZero();
    expect_agreement(spheres(centers, dice.distances()));
  }
}

/// The paths of a published system, with this many ends of each kind. Returns the run.
SolveRun expect_paths(const ProblemStatement& problem, const std::string& system, unsigned finite,
                      unsigned at_infinity) {
  SolveRun run = solved(problem, {{"method", "published"}, {"system", system}});
  INFO(system << ": " << run.reason);
  CHECK(run.counts.paths == finite + at_infinity);
  CHECK(run.counts.at_infinity == at_infinity);
  CHECK(run.counts.failed_paths == 0U);
  CHECK(run.failed_checks.empty());
  return run;
}

// Bézout: 2·2·2·2·2·2 = 64 and 2·3·4 = 24; Durand 1998 saw 40 of the 64 run to infinity.
TEST_CASE("the paths of the published systems end at both directions of 12 lines, or at infinity") {
  const auto expect_lines = [](const ProblemStatement& problem) {
    const SolveRun direct = solved(problem);
    for (const SolveRun& run :
         {expect_paths(problem, "quadrics", 24, 40), expect_paths(problem, "cubic", 24, 0)}) {
      CHECK(run.status == RunStatus::complete);
      CHECK(have_same_lines(direct, run));
    }
  };
  for (const std::string id : {"tangents-durand", "tangents-12-real", "tangents-equal-radii"})
    expect_lines(load_instance(id).problem);
  Dice dice(22);
  for (int i = 0; i < 20; ++i) expect_lines(dice.problem(Eigen::Matrix3d::Identity()));
}

TEST_CASE("what the published systems' paths do is counted where it is not as a rule") {
  // Multiple lines: as many paths, at three places.
  const ProblemStatement fourfold = load_instance("tangents-fourfold").problem;
  CHECK(expect_paths(fourfold, "quadrics", 24, 40).solutions.size() == 3);
  CHECK(expect_paths(fourfold, "cubic", 24, 0).solutions.size() == 3);
  // Centres on two parallel lines send two lines to infinity, with both directions.
  Eigen::Matrix<double, 3, 4> centers;
  centers << 0, 0.1, 2, 2.2, 0, 1, 0, 2, 0, 0.5, 0, 1;
  const ProblemStatement parallel = spheres(centers, {1, 0.9, 0.8, 0.95});
  const unsigned escaped = 2 * static_cast<unsigned>(solved(parallel).counts.at_infinity.value());
  REQUIRE(escaped > 0);
  expect_paths(parallel, "quadrics", 24 - escaped, 40 + escaped);
  // Collinear centres without a common tangent.
  centers << 0, 1, 2.5, 4, 0, 0, 0, 0, 0, 0, 0, 0;
  const ProblemStatement collinear = spheres(centers, {1, 1, 1, 2});
  const SolveRun none = solved(collinear, {{"method", "published"}});
  CHECK(none.counts.paths == 64U);
  CHECK(none.counts.at_infinity == 64U);
  CHECK(none.status == RunStatus::complete);
}

TEST_CASE("the cubic system refuses coplanar centres, and the quadrics have their lines") {
  Dice dice(23);
  Eigen::Matrix<double, 3, 4> centers = dice.centers();
  centers.row(2).setZero();
  const ProblemStatement flat = spheres(centers, dice.distances());
  const SolveRun cubic = solved(flat, {{"method", "published"}, {"system", "cubic"}});
  CHECK(cubic.status == RunStatus::gave_up);
  CHECK_THAT(cubic.reason, Catch::Contains("coplanar"));
  CHECK(have_same_lines(solved(flat), solved(flat, {{"method", "published"}, {"system", "quadrics"}})));
}

TEST_CASE("no paths are counted where none is followed") {
  const SolveRun direct = solved(load_instance("tangents-durand").problem);
  CHECK(direct.counts.paths.value_or(0) == 0);
  CHECK(direct.particulars.empty());
}

TEST_CASE("the paths have ends where centres are nearly coplanar and nearly collinear") {
  // The relative width of three points on a strip of this breadth is some hundredths.
  Dice dice(17);
  for (double height = 1; height > 1e-18; height /= 1e3)
    for (const double breadth : {1.0, 0.1, 0.03}) {
      Eigen::Matrix<double, 3, 4> centers = dice.centers();
      centers.row(1) *= breadth;
      centers.row(2) *= breadth * height;
      expect_agreement(spheres(centers, dice.distances()));
    }
}

TEST_CASE("centres in a narrow strip or needle have 12 tangents, which the paths find too") {
  Dice dice(19);
  for (const double breadth : {1e-2, 1e-3, 1e-4, 1e-6})
    for (const double thickness : {0.0, 1e-2, 1.0}) {
      const Eigen::Vector3d size(1, breadth, breadth * thickness);
      const ProblemStatement problem = dice.problem(dice.rotation() * size.asDiagonal());
      INFO("breadth " << breadth << ", thickness " << thickness);
      expect_twelve(problem);
      expect_agreement(problem);
    }
}

TEST_CASE("tangents whose coordinates do not hold their distances are proven to be twelve") {
  Dice dice(23);
  RunLimits limits;
  limits.certify = true;
  const std::vector<std::pair<std::string, OptionMap>> strategies{
      {"sphere-tangents", {}},
      {"sphere-tangents", {{"method", "homotopy"}}},
      {"monodromy", {}},
      {"polyhedral", {}}};
  for (const double breadth : {1e-6, 1e-8, 1e-10, 1e-12})
    for (const double thickness : {0.0, 1e-2, 1.0}) {
      const Eigen::Vector3d size(1, breadth, breadth * thickness);
      const Scene scene = Scene::unchecked(dice.problem(dice.rotation() * size.asDiagonal()));
      for (const auto& [strategy, options] : strategies) {
        const SolveRun run = run_strategy(find_strategy(strategy), options, scene, limits);
        INFO("breadth " << breadth << ", thickness " << thickness << ", " << strategy << ": " << run.reason);
        CHECK(run.status == RunStatus::complete);
        CHECK(run.counts.certified == 12U);
        CHECK(run.failed_checks.empty());
        CHECK(std::ranges::all_of(run.solutions,
                                  [](const AssessedSolution& line) { return line.error_bound.has_value(); }));
      }
    }
}

TEST_CASE("tangents that are near to each other in Cartesian coordinates are no multiple one") {
  // Of centres like these, in a plane and near to a line, one case in a hundred or so has eigenvalues that
  // rounding takes for multiple ones.
  Dice dice(21);
  for (const double breadth : {0.1, 0.03, 0.012})
    for (int i = 0; i < 200; ++i) expect_twelve(dice.problem(Eigen::Vector3d(1, breadth, 0).asDiagonal()));
}

TEST_CASE("parallel edges send tangents to infinity in a narrow strip too") {
  Eigen::Matrix<double, 3, 4> centers;
  centers << 0, 0.1, 2, 2.2, 0, 1, 0, 2, 0, 0.5, 0, 1;
  for (const double breadth : {1e-2, 1e-3, 1e-5}) {
    const ProblemStatement problem =
        spheres(Eigen::Vector3d(1, breadth, breadth).asDiagonal() * centers, {1, 0.9, 0.8, 0.95});
    const SolveRun run = solved(problem);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == 10);
    CHECK(run.counts.at_infinity == 2);
    expect_agreement(problem);
  }
}

TEST_CASE("no simple tangents are taken for a multiple one or for one at infinity in a narrow strip") {
  // Equal radii have tangents near to those of collinear centres, the others are near to isotropic
  // directions.
  Dice dice(20);
  for (const double breadth : {1e-2, 1e-3, 1e-4})
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector3d size(1, breadth, breadth);
      expect_twelve(spheres(size.asDiagonal() * dice.centers(), Eigen::Vector4d::Constant(0.5)));
    }
}

TEST_CASE("infinitely many tangents are named") {
  Eigen::Matrix<double, 3, 4> centers = Eigen::Matrix<double, 3, 4>::Zero();
  const Eigen::Vector4d position(0, 1, 2.5, 4);
  centers.row(1) = position;
  const auto on_parabola = [&](double alpha, double beta, double gamma) {
    ProblemStatement problem = spheres(centers, Eigen::Vector4d::Ones());
    for (int i = 0; i < 4; ++i) {
      problem.constraints[i].is_squared = true;
      problem.constraints[i].given.value = alpha + beta * position[i] + gamma * position[i] * position[i];
    }
    return problem;
  };
  // A line at distance 1 from the axis, at an angle of sine 1/2, met at 2.
  const SolveRun turned = solved(on_parabola(2, -1, 0.25));
  CHECK(turned.status == RunStatus::infinite);
  CHECK(turned.reason.find("turned about") != std::string::npos);
  const SolveRun complex = solved(on_parabola(1, 0, 2));
  CHECK(complex.status == RunStatus::infinite);
  CHECK(complex.reason.find("no real one") != std::string::npos);
  const SolveRun none = solved(spheres(centers, {1, 1, 1, 2}));
  CHECK(none.status == RunStatus::complete);
  CHECK(none.solutions.empty());
  const SolveRun axis = solved(spheres(centers, Eigen::Vector4d::Zero()));
  CHECK(axis.status == RunStatus::infinite);
  CHECK(axis.solutions.size() == 1);
}

// Lines in an isotropic plane through the line of three points have the distance 0 from all of them: two
// families with two parameters, of which the fourth distance takes one.
TEST_CASE("three points on a line at distance 0 have infinitely many tangents with any fourth sphere") {
  Eigen::Matrix<double, 3, 4> centers;
  centers << 0, 1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 0.5;
  for (const std::string method : {"direct", "homotopy"}) {
    const SolveRun run = solved(spheres(centers, {0, 0, 0, 1}), {{"method", method}});
    CHECK(run.status == RunStatus::infinite);
    CHECK(run.reason.find("curve of complex solutions") != std::string::npos);
    CHECK(solved(spheres(centers, {0, 0, 0.5, 1}), {{"method", method}}).status != RunStatus::infinite);
  }
}

TEST_CASE("coinciding centres have infinitely many tangents or none") {
  Dice dice(15);
  Eigen::Matrix<double, 3, 4> centers = dice.centers();
  centers.col(3) = centers.col(1);
  const SolveRun same = solved(spheres(centers, {1, 0.7, 0.8, 0.7}));
  CHECK(same.status == RunStatus::infinite);
  CHECK(same.reason.find("coincide") != std::string::npos);
  const SolveRun different = solved(spheres(centers, {1, 0.7, 0.8, 0.6}));
  CHECK(different.status == RunStatus::complete);
  CHECK(different.solutions.empty());
}

TEST_CASE("sphere-tangents says what it is not for") {
  CHECK(solved(load_instance("octahedron").problem).status == RunStatus::unsupported);
  CHECK(solved(load_instance("hoffmann-yuan").problem).status == RunStatus::unsupported);
}
