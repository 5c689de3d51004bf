#include "solvers/tracking/distance_curve.hpp"

#include <algorithm>

namespace gcs {

DistanceFamily::DistanceFamily(const Scene& scene, const Reference& reference, int order)
    : system_(scene, reference),
      lengths_(scene.length_paths(), order),
      edges_(system_.equations(), system_.dimension(), order),
      sketch_(scene.in_frame(*scene.sketch(), system_.reference())),
      points_(sketch_.points) {
  std::vector<double> fixed;
  Eigen::MatrixXi numbers(system_.dimension(), system_.point_count());
  for (int point = 0; point < system_.point_count(); ++point)
    for (int axis = 0; axis < system_.dimension(); ++axis) {
      const int unknown = system_.unknown(point, axis);
      numbers(axis, point) = unknown < 0 ? unknowns() + static_cast<int>(fixed.size()) : unknown;
      if (unknown < 0) fixed.push_back(sketch_.points(axis, point));
    }
  for (int axis = 0; axis < system_.dimension(); ++axis)
    for (int e = 0; e < system_.equations(); ++e) {
      const auto [a, b] = system_.edges()[e];
      differences_.push_back({numbers(axis, a), numbers(axis, b), e});
    }
  moving_.setZero(unknowns() + std::ssize(fixed));
  coordinates_ = moving_;
  std::ranges::copy(fixed, coordinates_.begin() + unknowns());
}

void DistanceFamily::residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  system_.place(y.head(unknowns()), points_);
  for (int e = 0; e < system_.equations(); ++e)
    f[e] = half_excess(points_, system_.edges()[e], lengths_.paths()[e], y[unknowns()]);
}

void DistanceFamily::wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  system_.place(y.head(unknowns()), points_);
  for (int e = 0; e < system_.equations(); ++e)
    f[e] = wide_half_excess(points_, system_.edges()[e], lengths_.paths()[e], y[unknowns()]);
}

void DistanceFamily::jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix) {
  const int m = system_.equations();
  const double t = y[unknowns()];
  matrix.setZero();
  coordinates_.head(unknowns()) = y.head(unknowns());
  for (const auto& [a, b, e] : differences_) {
    const double difference = coordinates_[a] - coordinates_[b];
    if (a < unknowns()) matrix(e, a) = difference;
    if (b < unknowns()) matrix(e, b) = -difference;
  }
  for (int e = 0; e < m; ++e) {
    const LengthPath& path = lengths_.paths()[e];
    matrix(e, unknowns()) = -path.value(t) * path.slope(t);
  }
}

Eigen::MatrixXd DistanceFamily::bordered_pattern() const {
  const int m = unknowns();
  Eigen::MatrixXd pattern = Eigen::MatrixXd::Zero(m + 1, m + 1);
  for (const auto& [a, b, e] : differences_)
    for (const int unknown : {a, b})
      if (unknown < m) pattern(e, unknown) = 1;
  pattern.row(m).setOnes();
  pattern.col(m).setOnes();
  return pattern;
}

void DistanceFamily::set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient) {
  lengths_.set(n, coefficient[unknowns()]);
  moving_.head(unknowns()) = coefficient.head(unknowns());
  auto difference = edges_.difference(n);
  for (Eigen::Index i = 0; i < difference.size(); ++i)
    difference[i] = moving_[differences_[i].minuend] - moving_[differences_[i].subtrahend];
}

void DistanceFamily::known(int n, Eigen::Ref<Eigen::VectorXd> result) {
  lengths_.known(n, result);
  edges_.subtract_half_convolution(n, result);
}

}  // namespace gcs
