#include "solvers/figures/residual_and_condition.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Sides 3, 4, 5: every distance is exact.
ProblemStatement right_triangle() {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.col(1) << 4, 0, 0;
  points.col(2) << 0, 3, 0;
  return samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, points, points);
}

double residual_in_long_double(const Scene& scene, const Figure& figure) {
  long double worst = 0;
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const auto [a, b] = scene.problem().constraints[i].between;
    long double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const long double difference =
          static_cast<long double>(figure.points(axis, a)) - static_cast<long double>(figure.points(axis, b));
      square += difference * difference;
    }
    const long double length = scene.target_lengths()[i];
    const long double scale = std::max(length, 1e-3L * scene.size());
    worst = std::max(worst, std::abs(std::sqrt(square) - length) / scale);
  }
  return static_cast<double>(worst);
}

/// Unit vectors along the edges in the columns of all coordinates, less those that the frame fixes.
double condition_by_definition(const Scene& scene, const Eigen::Matrix3Xcd& points) {
  const int d = scene.dimension();
  const Reference& reference = scene.reference();
  std::vector<std::pair<int, int>> free;
  for (int p = 0; p < points.cols(); ++p)
    for (int axis = 0; axis < d; ++axis) {
      if (p == reference.origin || (p == reference.axis && axis > 0)) continue;
      if (p == reference.plane && axis > 1) continue;
      free.emplace_back(p, axis);
    }
  Eigen::MatrixXcd matrix(scene.constraint_count(), static_cast<Eigen::Index>(free.size()));
  for (int e = 0; e < scene.constraint_count(); ++e) {
    const auto [a, b] = scene.problem().constraints[e].between;
    const Eigen::Vector3cd unit = points.col(a) - points.col(b);
    Eigen::VectorXcd row(matrix.cols());
    for (std::size_t c = 0; c < free.size(); ++c) {
      const auto [p, axis] = free[c];
      row[static_cast<Eigen::Index>(c)] = static_cast<double>((p == a) - (p == b)) * unit[axis];
    }
    matrix.row(e) = row.transpose() / row.norm();
  }
  // The eigenvalues of [0, A; A*, 0] are plus and minus the singular values of A (Jordan, Wielandt).
  const Eigen::Index n = matrix.cols();
  Eigen::MatrixXcd symmetric = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
  symmetric.topRightCorner(n, n) = matrix;
  symmetric.bottomLeftCorner(n, n) = matrix.adjoint();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(symmetric, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2 * n - 1] / solver.eigenvalues()[n];
}

}  // namespace

TEST_CASE("the residual of an exact solution is zero") {
  const Scene scene(right_triangle());
  CHECK(relative_residual(scene, *scene.sketch()) == 0);
}

TEST_CASE("the residual shows a shift of 1e-13 at its size") {
  const Scene scene(right_triangle());
  Figure figure = *scene.sketch();
  figure.points(0, 1) += 1e-13;
  // p2 moves along the side of length 4, which is 1 in the scene's unit.
  CHECK(relative_residual(scene, figure) == Approx(1e-13).epsilon(1e-2));
}

TEST_CASE("the residual is the largest relative error, as long double has it") {
  RandomNumbers random(1);
  double worst = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 6, random));
    Figure figure = *scene.sketch();
    const double expected = residual_in_long_double(scene, figure);
    worst = std::max(worst, std::abs(relative_residual(scene, figure) / expected - 1));
  }
  CHECK(worst <= 1e-14);
}

TEST_CASE("the residual of a figure that is not finite is infinite") {
  const Scene scene(right_triangle());
  Figure figure = *scene.sketch();
  figure.points(0, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK(relative_residual(scene, figure) == std::numeric_limits<double>::infinity());
}

TEST_CASE("distances to lines enter the residual") {
  ProblemStatement problem = samples::problem_of(3, 1, {{0, 1}}, {2});
  problem.lines = {"L"};
  const Scene scene(problem);
  Figure figure;
  figure.points = Eigen::Vector3d(7, 0, 1);
  figure.lines = {LinePosition{Eigen::Vector3d(-3, 0, 0), Eigen::Vector3d::UnitX()}};
  CHECK(relative_residual(scene, figure) == 0);
  figure.points(2, 0) += 1e-13;
  CHECK(relative_residual(scene, figure) == Approx(1e-13).epsilon(1e-2));
}

TEST_CASE("the condition number is that of the matrix of unit vectors") {
  RandomNumbers random(2);
  double worst = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 4 + random.index(5), random));
    const double expected =
        condition_by_definition(scene, scene.sketch()->points.cast<std::complex<double>>());
    const double relative = std::abs(jacobian_condition(scene, *scene.sketch()) / expected - 1);
    worst = std::max(worst, relative / expected);
  }
  CHECK(worst <= 1e-14);
}

TEST_CASE("the condition number of a complex figure is right to seven digits, or as rounding lets it") {
  RandomNumbers random(3);
  int ill_conditioned = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 4 + random.index(5), random));
    Figure figure = *scene.sketch();
    figure.imaginary = Eigen::Matrix3Xd::Zero(3, figure.points.cols());
    figure.imaginary.col(3).head(scene.dimension()) =
        random.point(scene.dimension(), 1).head(scene.dimension());
    // Nearly one point: two rows nearly the same.
    if (sample % 4 == 0) {
      figure.points.col(3) =
          figure.points.col(0) + std::pow(10.0, -random.index(9)) * random.point(scene.dimension(), 1);
      figure.imaginary.col(3) *= 1e-9;
    }
    Eigen::Matrix3Xcd points = figure.points.cast<std::complex<double>>();
    points.imag() = figure.imaginary;
    const double expected = condition_by_definition(scene, points);
    const double relative = std::abs(jacobian_condition(scene, figure) / expected - 1);
    ill_conditioned += expected > 1e4 ? 1 : 0;
    CHECK(relative <= (expected <= 1e4 ? 1e-7 : 1e-14 * expected));
  }
  CHECK(ill_conditioned > 5);
}

TEST_CASE("a singular figure has no finite condition number") {
  const Scene scene(right_triangle());
  Figure flat = *scene.sketch();
  flat.points.row(1).setZero();
  flat.points(0, 2) = 0.5;
  CHECK(jacobian_condition(scene, flat) == std::numeric_limits<double>::infinity());
  Figure collapsed = *scene.sketch();
  collapsed.points.col(2) = collapsed.points.col(1);
  CHECK(jacobian_condition(scene, collapsed) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a figure is stiff from a condition number on, however it is told") {
  // The third point at a falling height above the first two: the condition number grows like its inverse.
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.row(0) << 0, 2, 1;
  // With an orientation it is solved by the equations of general scenes.
  const Relation orientation{"o", "orientation", {{0}, {1}, {2}}, Relation::Form::none, {}, 1};
  for (const std::vector<Relation>& relations : {std::vector<Relation>{}, {orientation}}) {
    int stiff = 0;
    for (double height = 1; height > 1e-9; height /= 1.5) {
      points(1, 2) = height;
      ProblemStatement problem = samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, points, points);
      problem.relations = relations;
      const Scene scene(problem);
      const bool expected = jacobian_condition(scene, *scene.sketch()) >= stiff_condition;
      CAPTURE(height, relations.size());
      CHECK(is_stiff(scene, *scene.sketch()) == expected);
      stiff += expected ? 1 : 0;
    }
    CHECK(stiff > 10);
    CHECK(stiff < 40);
  }
}
