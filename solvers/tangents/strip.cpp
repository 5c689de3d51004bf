#include "solvers/tangents/strip.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

using Axis = std::array<DoubleDouble, 3>;

DoubleDouble product(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ComplexDoubleDouble product(const Axis& axis, const WideVector& v) {
  ComplexDoubleDouble sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + ComplexDoubleDouble{axis[i], {}} * v[i];
  return sum;
}

Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Axis normalised(const Axis& a) {
  const DoubleDouble length = sqrt(product(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

ComplexDoubleDouble times_i(const ComplexDoubleDouble& a) { return {-a.im, a.re}; }

/// From the first centre to the second.
Axis difference(const Sphere& from, const Sphere& to) {
  const auto along = [&](int axis) { return to.coordinate(axis) - from.coordinate(axis); };
  return {along(0), along(1), along(2)};
}

WideVector as_complex(const Axis& a) {
  return {ComplexDoubleDouble{a[0], {}}, ComplexDoubleDouble{a[1], {}}, ComplexDoubleDouble{a[2], {}}};
}

}  // namespace

Strip::Strip(const FourSpheres& spheres) : spheres_(spheres) {
  choose_axes();
  for (std::size_t i = 0; i < 3; ++i)
    centers_[i] = isotropic(as_complex(difference(spheres[0], spheres[i + 1])));
  choose_widening();
}

void Strip::choose_axes() {
  Axis longest{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double length = (spheres_[i].center - spheres_[j].center).norm();
      if (length <= length_) continue;
      length_ = length;
      longest = difference(spheres_[j], spheres_[i]);
    }
  axes_[0] = normalised(longest);
  Eigen::Index smallest = 0;
  Eigen::Vector3d(axes_[0][0].hi, axes_[0][1].hi, axes_[0][2].hi).cwiseAbs().minCoeff(&smallest);
  Axis across{};
  across[static_cast<std::size_t>(smallest)] = {1, 0};
  axes_[1] = normalised(cross(axes_[0], across));
  axes_[2] = cross(axes_[0], axes_[1]);
}

void Strip::choose_widening() {
  double across = 0;
  for (const WideVector& center : centers_) across = std::max(across, std::abs(center[1].value()));
  if (across > 0) widening_ = std::max(1.0, std::exp2(std::floor(std::log2(length_ / across))));
}

WideVector Strip::isotropic(const WideVector& cartesian) const {
  const ComplexDoubleDouble f = product(axes_[1], cartesian), ig = times_i(product(axes_[2], cartesian));
  return {product(axes_[0], cartesian), f + ig, f - ig};
}

WideVector Strip::cartesian(const WideVector& isotropic) const {
  const ComplexDoubleDouble half = widened(std::complex(0.5));
  const ComplexDoubleDouble f = half * (isotropic[1] + isotropic[2]);
  const ComplexDoubleDouble g = half * times_i(isotropic[2] - isotropic[1]);
  WideVector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = isotropic[0] * ComplexDoubleDouble{axes_[0][i], {}} +
                f * ComplexDoubleDouble{axes_[1][i], {}} + g * ComplexDoubleDouble{axes_[2][i], {}};
  return result;
}

WideVector Strip::wide_origin() const {
  const Sphere& first = spheres_[0];
  return as_complex({first.coordinate(0), first.coordinate(1), first.coordinate(2)});
}

FourSpheres Strip::widened_spheres() const {
  FourSpheres result = spheres_;
  const ComplexDoubleDouble factor = widened(std::complex(widening_));
  for (std::size_t i = 1; i < 4; ++i) {
    const auto& [along, plus, minus] = centers_[i - 1];
    const Eigen::Vector3cd moved = narrowed(cartesian({along, factor * plus, factor * minus}));
    result[i].center = spheres_[0].center + moved.real();
    result[i].center_rest.setZero();
  }
  return result;
}

}  // namespace gcs
