#include "solvers/model/distance_system.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/tests/quad.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::Quad;
using samples::RandomNumbers;

namespace {

/// A flat triangle: p3 between p1 and p2, lengths 2, 1, 1.
ProblemStatement flat_triangle() {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.row(0) << 0, 2, 1;
  return samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, points, points);
}

/// f_e at x in long double, by the definition.
long double half_square_difference(const DistanceSystem& system, const Eigen::VectorXd& x, int edge,
                                   int moved, long double step) {
  const Figure figure = system.figure(x);
  const auto [a, b] = system.edges()[edge];
  long double sum = 0;
  for (int axis = 0; axis < system.dimension(); ++axis) {
    long double pa = figure.points(axis, a);
    long double pb = figure.points(axis, b);
    if (system.unknown(a, axis) == moved) pa += step;
    if (system.unknown(b, axis) == moved) pb += step;
    sum += (pa - pb) * (pa - pb);
  }
  return sum / 2;
}

void check_jacobian(const ProblemStatement& problem) {
  const Scene scene = Scene::unchecked(problem);
  const DistanceSystem system(scene);
  REQUIRE(system.unknowns() == system.equations());
  const Eigen::VectorXd x = system.coordinates(*scene.sketch());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Constant(system.equations(), system.unknowns() + 1, 7);
  system.jacobian(scene.sketch()->points, jacobian);
  CHECK((jacobian.rightCols<1>().array() == 7).all());
  // f is quadratic: its central difference is its derivative, whatever the step.
  const long double step = 0.25L;
  double worst = 0;
  for (int e = 0; e < system.equations(); ++e)
    for (int i = 0; i < system.unknowns(); ++i) {
      const long double difference =
          (half_square_difference(system, x, e, i, step) - half_square_difference(system, x, e, i, -step)) /
          (2 * step);
      worst = std::max(worst, std::abs(jacobian(e, i) - static_cast<double>(difference)));
    }
  CHECK(worst <= 1e-15);
}

/// A problem whose targets are the sketch's own lengths.
ProblemStatement at_rest(ProblemStatement problem) {
  for (DistanceConstraint& c : problem.constraints) {
    const Eigen::Matrix3Xd& points = problem.sketch->points;
    c.given.value = (points.col(c.between[0]) - points.col(c.between[1])).norm();
  }
  return problem;
}

Eigen::VectorXd perturbed(Eigen::VectorXd x, double size, RandomNumbers& random) {
  for (double& value : x) value += random.uniform(-size, size);
  return x;
}

}  // namespace

TEST_CASE("the frame leaves exactly the coordinates that it does not fix") {
  const Scene plane(samples::k33());
  const DistanceSystem in_plane(plane);
  CHECK(in_plane.unknowns() == 9);
  CHECK(in_plane.unknown(0, 0) == -1);
  CHECK(in_plane.unknown(1, 1) == -1);
  CHECK(in_plane.unknown(1, 0) == 0);
  CHECK(in_plane.unknown(2, 2) == -1);

  const Scene space(samples::octahedron());
  const DistanceSystem in_space(space);
  CHECK(in_space.unknowns() == 12);
  std::set<int> unknowns;
  for (int point = 0; point < 6; ++point)
    for (int axis = 0; axis < 3; ++axis)
      if (in_space.unknown(point, axis) >= 0) unknowns.insert(in_space.unknown(point, axis));
  CHECK(unknowns.size() == 12);
  CHECK(*unknowns.rbegin() == 11);
}

TEST_CASE("coordinates and figures are two forms of the same") {
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()}) {
    const Scene scene = Scene::unchecked(problem);
    const DistanceSystem system(scene);
    const Eigen::VectorXd x = system.coordinates(*scene.sketch());
    CHECK(system.figure(x).points == scene.sketch()->points);
    CHECK(system.coordinates(system.figure(x)) == x);
  }
}

TEST_CASE("points with given positions are no unknowns and enter the figures scaled") {
  ProblemStatement problem = samples::problem_of(2, 3, {{0, 2}, {1, 2}}, {5, 5});
  problem.fixed_points = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(6, 0, 0), std::nullopt};
  const Scene scene = Scene::unchecked(problem);
  const DistanceSystem system(scene);
  CHECK(system.unknowns() == 2);
  Eigen::VectorXd x(2);
  x << 1, 1;
  const Figure figure = scene.in_file_unit(system.figure(x));
  CHECK(figure.points.col(1) == Eigen::Vector3d(6, 0, 0));
  CHECK(figure.points.col(2) == Eigen::Vector3d::Constant(std::ldexp(1.0, scene.unit_exponent()))
                                    .cwiseProduct(Eigen::Vector3d(1, 1, 0)));
}

TEST_CASE("the Jacobian is the derivative of the half squared distances") {
  check_jacobian(samples::k33());
  check_jacobian(samples::octahedron());
  RandomNumbers random(1);
  for (int sample = 0; sample < 20; ++sample)
    for (const int dimension : {2, 3})
      check_jacobian(samples::random_problem(dimension, dimension + 1 + random.index(8), random));
}

TEST_CASE("squared lengths are taken from the file without rounding") {
  RandomNumbers random(2);
  for (const bool squared : {false, true}) {
    ProblemStatement problem = samples::octahedron();
    for (DistanceConstraint& c : problem.constraints) {
      c.is_squared = squared;
      c.given.value = random.uniform(0.1, 40);
    }
    const Scene scene = Scene::unchecked(problem);
    const std::vector<DoubleDouble> squares = target_squares(scene);
    REQUIRE(squares.size() == problem.constraints.size());
    int wrong = 0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const Quad given = problem.constraints[i].given.value;
      const Quad unit = std::ldexp(1.0, scene.unit_exponent());
      const Quad exact = squared ? given : given * given;
      if ((Quad(squares[i].hi) + Quad(squares[i].lo)) * unit * unit != exact) ++wrong;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("Newton's method brings a disturbed solution back to the last bits") {
  RandomNumbers random(3);
  int judged = 0;
  double worst = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const int dimension = 2 + sample % 2;
    const Scene scene =
        Scene::unchecked(at_rest(samples::random_problem(dimension, 4 + random.index(6), random)));
    const double condition = jacobian_condition(scene, *scene.sketch());
    if (condition > 100) continue;
    ++judged;
    const DistanceSystem system(scene);
    const Eigen::VectorXd solution = system.coordinates(*scene.sketch());
    Eigen::VectorXd x = perturbed(solution, 1e-4, random);
    const Refinement refinement = refine(system, target_squares(scene), x);
    CHECK(refinement.converged);
    CHECK(refinement.iterations <= 6);
    CHECK(refinement.last_correction <= 1e-12);
    worst = std::max(worst, (x - solution).cwiseAbs().maxCoeff() / condition);
    CHECK(relative_residual(scene, system.figure(x)) <= 1e-15);
  }
  CHECK(judged >= 30);
  // The targets are lengths of the sketch in double; the condition number amplifies their rounding.
  CHECK(worst <= 1e-15);
}

TEST_CASE("Newton's method reports failure and leaves the point as it came") {
  SECTION("at a singular figure") {
    const Scene scene = Scene::unchecked(flat_triangle());
    const DistanceSystem system(scene);
    Eigen::VectorXd x = system.coordinates(*scene.sketch());
    x[0] += 0.25;
    const Eigen::VectorXd before = x;
    CHECK_FALSE(refine(system, target_squares(scene), x).converged);
    CHECK(x == before);
  }
  SECTION("where the lengths cannot be met") {
    ProblemStatement problem = flat_triangle();
    problem.constraints[1].given.value = 0.5;
    problem.constraints[2].given.value = 0.5;
    const Scene scene = Scene::unchecked(problem);
    const DistanceSystem system(scene);
    Eigen::VectorXd x = system.coordinates(*scene.sketch());
    x[2] = 0.3;
    const Eigen::VectorXd before = x;
    CHECK_FALSE(refine(system, target_squares(scene), x).converged);
    CHECK(x == before);
  }
  SECTION("at a point that is not finite") {
    const Scene scene(samples::k33());
    const DistanceSystem system(scene);
    Eigen::VectorXd x = Eigen::VectorXd::Constant(9, std::numeric_limits<double>::quiet_NaN());
    CHECK_FALSE(refine(system, target_squares(scene), x).converged);
  }
}

TEST_CASE("with a line in the frame, the derivatives are those of squared distances") {
  ProblemStatement problem = samples::problem_of(3, 2, {{0, 2}, {2, 1}, {0, 1}}, {1, 2, 3});
  problem.lines = {"L"};
  problem.reference = Reference{-1, -1, -1, 0, 1};
  const Scene scene = Scene::unchecked(problem);
  const DistanceSystem system(scene);
  CHECK(system.unknowns() == 4);  // the height point has z alone
  const Eigen::Vector4d x(0.5, -1.25, 0.75, 2);
  const Eigen::Matrix3Xd points = system.figure(x).points;
  CHECK(points.col(1) == Eigen::Vector3d(0, 0, 2));
  CHECK(system.squared_length(points, 0).value() == 1.25 * 1.25 + 0.75 * 0.75);
  CHECK(system.squared_length(points, 1).value() == 4);
  CHECK(system.squared_length(points, 2).value() == 0.25 + 1.5625 + 1.5625);
  Eigen::MatrixXd jacobian(3, 4);
  system.jacobian(points, jacobian);
  Eigen::MatrixXd expected(3, 4);
  expected << 0, -1.25, 0.75, 0, 0, 0, 0, 2, 0.5, -1.25, -1.25, 1.25;
  CHECK(jacobian == expected);
}

TEST_CASE("target squares are those of the decimals") {
  ProblemStatement problem = flat_triangle();
  problem.constraints[0].given = {1.1, "1.1"};
  problem.constraints[1].given = {1.21, "1.21"};
  problem.constraints[1].is_squared = true;
  const std::vector<DoubleDouble> squares = target_squares(Scene::unchecked(problem));
  CHECK(squares[0].hi == squares[1].hi);
  CHECK(squares[0].lo == squares[1].lo);
  CHECK(squares[0].lo != 0);
}
