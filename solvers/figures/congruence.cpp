#include "solvers/figures/congruence.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

using Row = Eigen::Matrix<std::complex<double>, 1, Eigen::Dynamic>;

/// A direction whose square is less than this part of its squared length is nearly isotropic.
constexpr double least_square = 1e-2;

/// A point moves by a tolerance with the first one, its coordinate by as much again with the axis.
constexpr double growth = 4;

Eigen::Index furthest(const ComplexPoints& a, const ComplexPoints& b) {
  Eigen::Index pivot = 0;
  (a.colwise().squaredNorm() + b.colwise().squaredNorm()).maxCoeff(&pivot);
  return pivot;
}

/// The vector's squared length over its square: 1 where it is real.
double isotropy(const Eigen::Vector3cd& v) { return v.squaredNorm() / std::abs(v.cwiseProduct(v).sum()); }

/// The coordinates along the axis through the origin and that point, which are taken off the points.
Row take_axis(ComplexPoints& points, Eigen::Index through) {
  const Eigen::Vector3cd v = points.col(through);
  const Eigen::Vector3cd axis = v / std::sqrt(v.cwiseProduct(v).sum());
  const Row row = axis.transpose() * points;
  points -= axis * row;
  return row;
}

double largest_difference(const Row& a, const Row& b) {
  return std::min((a - b).cwiseAbs().maxCoeff(), (a + b).cwiseAbs().maxCoeff());
}

}  // namespace

bool may_be_congruent(ComplexPoints a, ComplexPoints b, double tolerance) {
  for (ComplexPoints* points : {&a, &b}) {
    const Eigen::Vector3cd origin = points->col(0);
    points->colwise() -= origin;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Index pivot = furthest(a, b);
    const auto [least, most] = std::minmax({a.col(pivot).norm(), b.col(pivot).norm()});
    tolerance *= growth;
    if (most <= tolerance) return true;
    if (least == 0) return false;
    const double stretch = std::max(isotropy(a.col(pivot)), isotropy(b.col(pivot)));
    if (!(stretch * least_square < 1)) return true;
    tolerance *= stretch;
    if (largest_difference(take_axis(a, pivot), take_axis(b, pivot)) > tolerance) return false;
  }
  return true;
}

}  // namespace gcs
