#include "solvers/model/quality.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

}  // namespace

double relative_residual(const Scene& scene, const Figure& figure) {
  double worst = 0;
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const double length = scene.target_lengths()[i];
    const double error =
        std::abs(distance(scene.problem(), figure, scene.problem().constraints[i].between) - length);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, error / std::max(length, 1e-3 * scene.size()));
  }
  return worst;
}

double jacobian_condition(const Scene& scene, const Figure& figure) {
  const DistanceSystem system(scene);
  Eigen::MatrixXd jacobian(system.equations(), system.unknowns());
  system.jacobian(figure.points, jacobian);
  jacobian.rowwise().normalize();
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
  const double smallest = singular.minCoeff();
  return smallest > 0 ? singular.maxCoeff() / smallest : std::numeric_limits<double>::infinity();
}

}  // namespace gcs
