#include "solvers/reduction/simplex_coordinates.hpp"

namespace gcs {
namespace {

std::complex<double> product(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
  return (a.array() * b.array()).sum();
}

/// Eigen's would conjugate.
Eigen::Vector3cd cross(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Simplex columns(const Simplex& positions, const std::vector<int>& points) {
  Simplex result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = positions.col(points[i]);
  return result;
}

SimplexFrame::SimplexFrame(const Simplex& base) : origin_(base.col(0)), axes_(Eigen::Matrix3cd::Zero()) {
  const Eigen::Vector3cd e = base.col(1) - origin_;
  axes_.col(0) = e;
  if (base.cols() == 2) {
    axes_.col(2) = Eigen::Vector3cd(-e[1], e[0], 0);
    return;
  }
  const Eigen::Vector3cd second = base.col(2) - origin_;
  const Eigen::Vector3cd v = second - e * (product(second, e) / product(e, e));
  axes_.col(1) = v - e * (product(v, e) / product(e, e));
  axes_.col(2) = cross(e, axes_.col(1));
}

SimplexCoordinates SimplexFrame::coordinates(const Eigen::Vector3cd& point) const {
  SimplexCoordinates result = SimplexCoordinates::Zero();
  const Eigen::Vector3cd offset = point - origin_;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3cd axis = axes_.col(i);
    const std::complex<double> square = product(axis, axis);
    if (square != 0.0) result[i] = product(offset, axis) / square;
  }
  return result;
}

Eigen::Vector3cd SimplexFrame::point(const SimplexCoordinates& coordinates) const {
  return origin_ + axes_ * coordinates;
}

}  // namespace gcs
