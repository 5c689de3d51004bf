#include "solvers/certificates/krawczyk.hpp"

#include <Eigen/LU>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// How far |p − q|²/2 moves when given coordinates move from their doubles to the file's decimals.
double error_of_given(const DistanceSystem& system, const Eigen::Matrix3Xd& points, int e) {
  const auto [a, b] = system.edges()[e];
  double error = 0;
  for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
    const double apart = points(axis, a) - (system.is_line(b) ? 0 : points(axis, b));
    const double moved = system.coordinate_error(a, axis) + system.coordinate_error(b, axis);
    error += (std::abs(apart) + moved) * moved;
  }
  return error * (1 + 8 * epsilon);
}

/// f(mid), each with a bound on its error: squares in double-double are right to `epsilon`² relative to their
/// terms, or to what underflows, and the sum is rounded once.
LinearisedSystem<double> linearised(const DistanceSystem& system, const std::vector<DoubleDouble>& squares,
                                    const Eigen::Matrix3Xd& points) {
  const int m = system.unknowns();
  LinearisedSystem<double> f{Eigen::VectorXd(m), Eigen::VectorXd(m), Eigen::MatrixXd(m, m)};
  for (int e = 0; e < system.equations(); ++e) {
    const DoubleDouble square = system.squared_length(points, e);
    f.value[e] = (square - squares[e]).value() / 2;
    f.value_error[e] = epsilon * std::abs(f.value[e]) +
                       64 * epsilon * epsilon * (std::abs(square.hi) + std::abs(squares[e].hi)) + underflow +
                       error_of_given(system, points, e);
  }
  system.jacobian(points, f.jacobian);
  return f;
}

/// How far the entries of the Jacobian, which are differences of coordinates, move within the box and from
/// given coordinates' doubles to their decimals.
Eigen::MatrixXd jacobian_radius(const DistanceSystem& system, const Eigen::VectorXd& box_radius) {
  Eigen::MatrixXd radius = Eigen::MatrixXd::Zero(system.equations(), system.unknowns());
  const auto radius_of = [&](int entity, int axis) {
    const int unknown = system.unknown(entity, axis);
    return unknown >= 0 ? box_radius[unknown] : system.coordinate_error(entity, axis);
  };
  for (int e = 0; e < system.equations(); ++e) {
    const auto [a, b] = system.edges()[e];
    // The foot on the line, the x-axis, moves along with the point.
    for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
      const int i = system.unknown(a, axis);
      const int j = system.unknown(b, axis);
      const double sum = radius_of(a, axis) + radius_of(b, axis);
      if (i >= 0) radius(e, i) = sum;
      if (j >= 0) radius(e, j) = sum;
    }
  }
  return radius;
}

}  // namespace

BoxContent krawczyk(const DistanceSystem& system, const std::vector<DoubleDouble>& squares, const Box& box) {
  const LinearisedSystem<double> f = linearised(system, squares, system.figure(box.mid).points);
  const Eigen::MatrixXd inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return BoxContent::unknown;
  const KrawczykImage<double> image =
      krawczyk_image(inverse, f, jacobian_radius(system, box.radius), box.radius);
  if (image.is_inside(box.radius)) return BoxContent::one_solution;
  return image.misses(box.radius) ? BoxContent::no_solution : BoxContent::unknown;
}

std::optional<KrawczykImage<double>> krawczyk_image_along(const Eigen::MatrixXd& axes,
                                                          LinearisedSystem<double> f,
                                                          const Eigen::MatrixXd& jacobian_radius,
                                                          const Eigen::VectorXd& radius) {
  const Eigen::MatrixXd size = axes.cwiseAbs();
  const double rounding = static_cast<double>(axes.rows() + 4) * epsilon;
  const Eigen::MatrixXd radius_along =
      (jacobian_radius * (1 + rounding) + rounding * f.jacobian.cwiseAbs()) * size * (1 + rounding);
  f.jacobian = f.jacobian * axes;
  const Eigen::MatrixXd inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  return krawczyk_image(inverse, f, radius_along, radius);
}

std::optional<KrawczykImage<double>> krawczyk_image(const DistanceSystem& system,
                                                    const std::vector<DoubleDouble>& squares,
                                                    const Eigen::MatrixXd& axes, const SkewBox& box) {
  return krawczyk_image_along(axes, linearised(system, squares, system.figure(box.mid).points),
                              jacobian_radius(system, axes.cwiseAbs() * box.radius), box.radius);
}

}  // namespace gcs
