#include "solvers/tracking/distance_curve.hpp"

namespace gcs {

DistanceFamily::DistanceFamily(const Scene& scene, const Reference& reference, int order)
    : system_(scene, reference),
      lengths_(scene.length_paths(), order),
      edges_(system_.equations(), system_.dimension(), order),
      sketch_(scene.in_frame(*scene.sketch(), system_.reference())),
      points_(sketch_.points),
      moving_(Eigen::Matrix3Xd::Zero(3, system_.point_count())),
      half_convolution_(system_.equations()) {}

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
  system_.place(y.head(unknowns()), points_);
  system_.jacobian(points_, matrix.topRows(m));
  for (int e = 0; e < m; ++e) {
    const LengthPath& path = lengths_.paths()[e];
    matrix(e, unknowns()) = -path.value(t) * path.slope(t);
  }
}

void DistanceFamily::set(int n, const Eigen::VectorXd& coefficient) {
  lengths_.set(n, coefficient[unknowns()]);
  system_.place(coefficient.head(unknowns()), moving_);
  auto difference = edges_.difference(n);
  Eigen::Index i = 0;
  for (int axis = 0; axis < system_.dimension(); ++axis)
    for (const auto& [a, b] : system_.edges()) difference[i++] = moving_(axis, a) - moving_(axis, b);
}

void DistanceFamily::known(int n, Eigen::Ref<Eigen::VectorXd> result) {
  lengths_.known(n, result);
  edges_.half_convolution(n, half_convolution_);
  result -= half_convolution_;
}

}  // namespace gcs
