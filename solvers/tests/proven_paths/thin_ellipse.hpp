#pragma once
/// A path that is known in closed form: the third point of a triangle whose base stands still while one of
/// the other sides grows as the other shrinks runs around an ellipse with the base's ends as foci. The
/// ellipse is thin, so that two arcs of S run side by side, and it has two folds of t.

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/proven_paths/path_tube.hpp"
#include "solvers/tracking/distance_curve.hpp"

namespace gcs::samples {

inline constexpr double base = 1, sum_of_sides = 1.005;
inline constexpr double side_at_start = 0.5, side_at_target = 0.7;
inline constexpr double semi_major = sum_of_sides / 2;

/// The third point at which the side from the origin has this length, above the base.
inline Eigen::Vector3d corner(double side) {
  const double other = sum_of_sides - side, x = (side * side - other * other + base) / (2 * base);
  return {x, std::sqrt(side * side - x * x), 0};
}

inline ProblemStatement thin_ellipse() {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"a", "b", "c"};
  problem.constraints = {{"a1", {0, 1}, {base, ""}, false},
                         {"a2", {0, 2}, {side_at_target, ""}, false},
                         {"a3", {1, 2}, {sum_of_sides - side_at_target, ""}, false}};
  problem.reference = Reference{0, 1, -1, -1, -1};
  problem.interpolation = {0, 0};
  Figure sketch;
  sketch.points = Eigen::Matrix3Xd::Zero(3, 3);
  sketch.points(0, 1) = base;
  sketch.points.col(2) = corner(side_at_start);
  problem.sketch = sketch;
  return problem;
}

struct Ellipse {
  Ellipse() : scene(thin_ellipse()), system(scene), data(enclose_path_data(scene, system)) {}

  double unit() const { return std::ldexp(1.0, -scene.unit_exponent()); }

  /// The point of S with this side, above (1) or below (−1) the base.
  Eigen::VectorXd point(double side, int half) const {
    Figure figure;
    figure.points = Eigen::Matrix3Xd::Zero(3, 3);
    figure.points(0, 1) = base * unit();
    figure.points.col(2) = unit() * corner(side);
    figure.points(1, 2) *= half;
    Eigen::VectorXd y(system.unknowns() + 1);
    y << system.coordinates(figure), (side - side_at_start) / (side_at_target - side_at_start);
    return y;
  }

  /// The same by the ellipse's eccentric angle, which falls where S leaves the sketch towards growing t.
  Eigen::VectorXd point_at(double angle) const {
    const double side = semi_major + base / 2 * std::cos(angle);
    const double semi_minor = std::sqrt((semi_major - base / 2) * (semi_major + base / 2));
    Eigen::VectorXd y(4);
    y << base * unit(), (base / 2 + semi_major * std::cos(angle)) * unit(),
        semi_minor * std::sin(angle) * unit(), (side - side_at_start) / (side_at_target - side_at_start);
    return y;
  }
  static double angle_at_start() { return std::acos((side_at_start - semi_major) / (base / 2)); }

  /// Known to few units in the last place of the ellipse's small axis, which is 14 times shorter.
  PointBox box(double side, int half) const {
    const Eigen::VectorXd y = point(side, half);
    return {y, Eigen::VectorXd::Constant(y.size(), 1e-13)};
  }

  /// The series at the point with this side, above the base, towards growing t.
  ArcSeries series(double side) const {
    DistanceCurve curve(scene, order, 1e-7);
    ArcSeries result(curve.coordinates(), order);
    REQUIRE(curve.start(1, result));
    Eigen::VectorXd y = point(side, 1);
    const Eigen::VectorXd tangent = (y - point(side - 1e-8, 1)).normalized();
    REQUIRE(curve.advance(y, tangent, result, false));
    return result;
  }

  PathTube tube() const { return PathTube(distance_equations(system), data.lengths, order); }
  static Eigen::ArrayXd no_room() { return Eigen::ArrayXd::Zero(3); }

  static Eigen::MatrixXd no_spread() { return Eigen::MatrixXd(0, 4); }

  static constexpr int order = 12;
  Scene scene;
  DistanceSystem system;
  PathData data;
};

}  // namespace gcs::samples
