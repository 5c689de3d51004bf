/// Krawczyk's test on a triangle, whose third point has two positions.

#include "solvers/certificates/krawczyk.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace gcs;

namespace {

/// Sides 1, 1 and the base: the third point at (base/2, ±√(1 − base²/4)).
ProblemStatement triangle(double base) {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"a", "b", "c"};
  problem.constraints = {
      {"a1", {0, 1}, {base, ""}, false}, {"a2", {0, 2}, {1, ""}, false}, {"a3", {1, 2}, {1, ""}, false}};
  problem.reference = Reference{0, 1, -1, -1, -1};
  return problem;
}

struct Triangle {
  explicit Triangle(double base)
      : scene(triangle(base)),
        system(scene),
        squares(target_squares(scene)),
        unit(std::ldexp(1.0, -scene.unit_exponent())) {}

  /// Around the point (x, y) of c, with the base right.
  BoxContent holds(double base, double x, double y, double radius) const {
    Figure figure;
    figure.points = Eigen::Matrix3Xd::Zero(3, 3);
    figure.points(0, 1) = base * unit;
    figure.points.col(2) << x * unit, y * unit, 0;
    const Eigen::VectorXd mid = system.coordinates(figure);
    return krawczyk(system, squares, {mid, Eigen::VectorXd::Constant(mid.size(), radius * unit)});
  }

  Scene scene;
  DistanceSystem system;
  std::vector<DoubleDouble> squares;
  double unit;
};

}  // namespace

TEST_CASE("a box around a regular solution holds one") {
  const Triangle triangle(1);
  const double height = std::sqrt(0.75);
  for (const double radius : {1e-12, 1e-6, 1e-2}) {
    CHECK(triangle.holds(1, 0.5, height, radius) == BoxContent::one_solution);
    CHECK(triangle.holds(1, 0.5, -height, radius) == BoxContent::one_solution);
  }
}

TEST_CASE("a near miss is excluded, and a box that shows both positions is not decided") {
  const Triangle triangle(1);
  const double height = std::sqrt(0.75);
  CHECK(triangle.holds(1, 0.5, height + 1e-9, 1e-10) == BoxContent::no_solution);
  CHECK(triangle.holds(1, 0.5, height + 1e-3, 1e-4) == BoxContent::no_solution);
  CHECK(triangle.holds(1, 0.5, 0.1, 1) == BoxContent::unknown);
}

TEST_CASE("a double solution is never decided") {
  // The third point lies on the base: both positions coincide.
  const Triangle flat(2);
  for (const double radius : {1e-14, 1e-10, 1e-6, 1e-2})
    CHECK(flat.holds(2, 1, 0, radius) == BoxContent::unknown);
}
