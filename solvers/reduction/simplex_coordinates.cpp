#include "solvers/reduction/simplex_coordinates.hpp"

#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

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
  const Eigen::Vector3cd v = second - e * (bilinear_product(second, e) / bilinear_product(e, e));
  axes_.col(1) = v - e * (bilinear_product(v, e) / bilinear_product(e, e));
  axes_.col(2) = cross_product(e, axes_.col(1));
}

SimplexCoordinates SimplexFrame::coordinates(const Eigen::Vector3cd& point) const {
  SimplexCoordinates result = SimplexCoordinates::Zero();
  const Eigen::Vector3cd offset = point - origin_;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3cd axis = axes_.col(i);
    const std::complex<double> square = bilinear_product(axis, axis);
    if (square != 0.0) result[i] = bilinear_product(offset, axis) / square;
  }
  return result;
}

Eigen::Vector3cd SimplexFrame::point(const SimplexCoordinates& coordinates) const {
  return origin_ + axes_ * coordinates;
}

}  // namespace gcs
