#include "solvers/tracking/distance_curve.hpp"

#include "solvers/tracking/corrector.hpp"

namespace gcs {

DistanceCurve::DistanceCurve(const Scene& scene, int order, double tolerance)
    : DistanceCurve(scene, scene.reference(), order, tolerance) {}

DistanceCurve::DistanceCurve(const Scene& scene, const Reference& reference, int order, double tolerance)
    : system_(scene, reference),
      lengths_(scene.length_paths(), order),
      edges_(system_.equations(), system_.dimension(), order),
      tolerance_(tolerance),
      sketch_(scene.in_frame(*scene.sketch(), system_.reference())),
      points_(sketch_.points),
      moving_(Eigen::Matrix3Xd::Zero(3, system_.point_count())),
      bordered_(coordinates(), coordinates()),
      lu_(coordinates()),
      right_side_(coordinates()),
      correction_(coordinates()),
      half_convolution_(system_.equations()) {}

void DistanceCurve::residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  ++work_.evaluations;
  const double t = y[system_.unknowns()];
  system_.place(y.head(system_.unknowns()), points_);
  for (int e = 0; e < system_.equations(); ++e) {
    const auto [a, b] = system_.edges()[e];
    const double length = lengths_.paths()[e].value(t);
    f[e] = ((points_.col(a) - points_.col(b)).squaredNorm() - length * length) / 2;
  }
}

void DistanceCurve::jacobian(const Eigen::VectorXd& y) {
  ++work_.jacobians;
  const int m = system_.equations();
  const double t = y[system_.unknowns()];
  system_.place(y.head(system_.unknowns()), points_);
  system_.jacobian(points_, bordered_.topRows(m));
  for (int e = 0; e < m; ++e) {
    const LengthPath& path = lengths_.paths()[e];
    bordered_(e, system_.unknowns()) = -path.value(t) * path.slope(t);
  }
}

void DistanceCurve::factorise(const Eigen::VectorXd& y, const Eigen::VectorXd& last_row) {
  jacobian(y);
  bordered_.bottomRows<1>() = last_row.transpose();
  lu_.compute(bordered_);
  ++work_.factorisations;
}

bool DistanceCurve::start(int orientation, ArcSeries& series) {
  Eigen::VectorXd y(coordinates());
  y << system_.coordinates(sketch_), 0.0;
  jacobian(y);
  const Eigen::FullPivLU<Eigen::MatrixXd> full(bordered_.topRows(system_.equations()));
  ++work_.factorisations;
  if (full.rank() < system_.equations()) return false;
  Eigen::VectorXd tangent = full.kernel().col(0).normalized();
  if (tangent[system_.unknowns()] * orientation < 0) tangent = -tangent;
  factorise(y, tangent);
  side_ = determinant_sign(lu_);
  expand(y, series);
  return true;
}

bool DistanceCurve::advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series) {
  const Eigen::Index m = system_.equations();
  right_side_[m] = 0;
  residual(y, right_side_.head(m));
  factorise(y, tangent);
  if (determinant_sign(lu_) != side_) return false;
  CorrectorTest test(tolerance_);
  while (true) {
    correction_ = lu_.solve(right_side_);
    y -= correction_;
    ++work_.newton_iterations;
    const CorrectorTest::Verdict verdict = test.judge(correction_.norm(), y.norm());
    if (verdict == CorrectorTest::Verdict::refuse) return false;
    if (verdict == CorrectorTest::Verdict::settled) break;
    residual(y, right_side_.head(m));
  }
  if (shortest_length(y[m]) < 0) return false;
  if (test.matrix_is_stale()) factorise(y, tangent);
  expand(y, series);
  return true;
}

void DistanceCurve::renew(ArcSeries& series) {
  const Eigen::VectorXd y = series.coefficient(0);
  factorise(y, series.coefficient(1));
  expand(y, series);
}

void DistanceCurve::set_differences(int n, const ArcSeries& series) {
  const auto coefficient = series.coefficient(n);
  lengths_.set(n, coefficient[system_.unknowns()]);
  system_.place(coefficient.head(system_.unknowns()), moving_);
  auto difference = edges_.difference(n);
  Eigen::Index i = 0;
  for (int axis = 0; axis < system_.dimension(); ++axis)
    for (const auto& [a, b] : system_.edges()) difference[i++] = moving_(axis, a) - moving_(axis, b);
}

/// Σ over the orders: B c_n = −constant_n with the factorised B = [f_x, f_t; tangent];
/// see ArcSeries for the last row.
void DistanceCurve::expand(const Eigen::VectorXd& y, ArcSeries& series) {
  const Eigen::Index m = system_.equations();
  lengths_.start(y[system_.unknowns()]);
  series.coefficient(0) = y;
  right_side_.setZero();
  right_side_[m] = 1;
  correction_ = lu_.solve(right_side_);
  series.coefficient(1) = correction_ / correction_.norm();
  set_differences(1, series);
  for (int n = 2; n <= series.order(); ++n) {
    lengths_.known(n, right_side_.head(m));
    edges_.half_convolution(n, half_convolution_);
    right_side_.head(m) -= half_convolution_;
    right_side_[m] = series.arc_length_term(n);
    correction_ = lu_.solve(right_side_);
    series.coefficient(n) = correction_;
    if (n < series.order()) set_differences(n, series);
  }
}

}  // namespace gcs
