#include "solvers/tangents/scaled_line.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {

ScaledLine ScaledLine::of(const Strip& strip, const Tangent<std::complex<double>>& line) {
  constexpr double nearly_isotropic = 16;
  const Eigen::Vector3cd from_first = line.point - strip.origin().cast<std::complex<double>>();
  Eigen::Vector3cd u = narrowed(strip.isotropic(widened(line.direction)));
  Eigen::Vector3cd p = narrowed(strip.isotropic(widened(from_first)));
  const int large = std::abs(u[1]) > std::abs(u[2]) ? 1 : 2, small = 3 - large;
  if (std::abs(u[large]) < nearly_isotropic)
    return {u, isotropic_product(u, u) * p - isotropic_product(u, p) * u};
  u[small] = (1.0 - u[0] * u[0]) / u[large];
  p[small] = -(2.0 * p[0] * u[0] + p[large] * u[small]) / u[large];
  return {u, p};
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

ScaledLine ScaledLine::conjugate() const {
  const auto conjugated = [](const Eigen::Vector3cd& v) {
    return Eigen::Vector3cd(std::conj(v[0]), std::conj(v[2]), std::conj(v[1]));
  };
  return {conjugated(direction), conjugated(scaled_point)};
}

double difference(const ScaledLine& a, const ScaledLine& b, double largest) {
  const double rotation = a.balancing_rotation(largest);
  const ScaledLine one = a.turned(rotation), other = b.turned(rotation);
  const double along =
      std::min((one.direction - other.direction).norm(), (one.direction + other.direction).norm());
  return std::max(along / one.direction.norm(),
                  (one.scaled_point - other.scaled_point).norm() / (1 + one.scaled_point.norm()));
}

}  // namespace gcs
