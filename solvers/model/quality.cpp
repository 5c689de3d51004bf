#include "solvers/model/quality.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

using Vector = std::array<DoubleDouble, 3>;

Vector difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {two_sum(a[0], -b[0]), two_sum(a[1], -b[1]), two_sum(a[2], -b[2])};
}

DoubleDouble squared_norm(const Vector& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// |(p − q) × u| / |u|
double distance_to_line(const Eigen::Vector3d& point, const LinePosition& line) {
  const Vector w = difference(point, line.point);
  const Vector u = difference(line.direction, Eigen::Vector3d::Zero());
  const Vector cross{w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
  return sqrt(squared_norm(cross)).value() / sqrt(squared_norm(u)).value();
}

double distance(const Problem& problem, const Figure& figure, std::array<int, 2> between) {
  if (!problem.is_point(between[0])) std::swap(between[0], between[1]);
  const Eigen::Vector3d first = figure.points.col(between[0]);
  if (!problem.is_point(between[1]))
    return distance_to_line(first, figure.lines[between[1] - problem.points.size()]);
  return sqrt(squared_distance(first, Eigen::Vector3d(figure.points.col(between[1])), 3)).value();
}

/// |√(q·q) − length| for the difference q of two complex points, the root with positive real part.
double complex_error(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, double length) {
  const std::complex<double> excess = squared_distance_excess(a, b, two_product(length, length));
  return std::abs(excess / (std::sqrt(excess + length * length) + length));
}

double error_of(const Scene& scene, const Figure& figure, int constraint) {
  const auto [a, b] = scene.problem().constraints[constraint].between;
  const double length = scene.target_lengths()[constraint];
  if (figure.is_real()) return std::abs(distance(scene.problem(), figure, {a, b}) - length);
  const ComplexPoints points = complex_points(figure);
  return complex_error(points.col(a), points.col(b), length);
}

/// A + iB as [A, −B; B, A], which has the same singular values, each twice.
Eigen::MatrixXd real_embedding(const Eigen::MatrixXd& real, const Eigen::MatrixXd& imaginary) {
  Eigen::MatrixXd embedded(2 * real.rows(), 2 * real.cols());
  embedded << real, -imaginary, imaginary, real;
  return embedded;
}

}  // namespace

double relative_residual(const Scene& scene, const Figure& figure) {
  double worst = 0;
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const double length = scene.target_lengths()[i];
    const double error = error_of(scene, figure, i);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, error / std::max(length, 1e-3 * scene.size()));
  }
  return worst;
}

double jacobian_condition(const Scene& scene, const Figure& figure) {
  const DistanceSystem system(scene);
  Eigen::MatrixXd jacobian(system.equations(), system.unknowns());
  system.jacobian(scene.has_lines() ? scene.in_frame(figure, system.reference()).points : figure.points,
                  jacobian);
  if (!figure.is_real()) {
    Eigen::MatrixXd imaginary(system.equations(), system.unknowns());
    system.jacobian(figure.imaginary, imaginary);
    jacobian = real_embedding(jacobian, imaginary);
  }
  jacobian.rowwise().normalize();
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
  const double smallest = singular.minCoeff();
  return smallest > 0 ? singular.maxCoeff() / smallest : std::numeric_limits<double>::infinity();
}

}  // namespace gcs
