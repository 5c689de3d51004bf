#include "solvers/tangents/scaled_line.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {

ScaledLine ScaledLine::of(const Strip& strip, const Tangent<std::complex<double>>& line) {
  const Eigen::Vector3cd from_first = line.point - strip.origin().cast<std::complex<double>>();
  const Eigen::Vector3cd u = narrowed(strip.isotropic(widened(line.direction)));
  const Eigen::Vector3cd p = narrowed(strip.isotropic(widened(from_first)));
  return {u, isotropic_product(u, u) * p - isotropic_product(u, p) * u};
}

ScaledLine ScaledLine::turned(double b) const {
  return {turned_by(b, direction), turned_by(b, scaled_point)};
}

double ScaledLine::balancing_rotation(double largest) const {
  const double ratio = std::abs(direction[1]) / std::abs(direction[2]);
  const double b = std::clamp(std::sqrt(ratio), 1 / largest, largest);
  return std::isfinite(b) ? std::exp2(std::round(std::log2(b))) : 1;
}

ScaledLine ScaledLine::normalised() const {
  const double size = std::max(direction.norm(), std::sqrt(scaled_point.norm()));
  return {direction / size, scaled_point / (size * size)};
}

}  // namespace gcs
