#pragma once
/// A curve of equations F(x, t) = 0 that are quadratic in x, as the series tracker wants it.

#include <Eigen/LU>
#include <concepts>
#include <utility>

#include "solvers/running/work.hpp"
#include "solvers/tracking/arc_series.hpp"
#include "solvers/tracking/corrector.hpp"

namespace gcs {

/// (x, t)
inline Eigen::VectorXd with_time(const Eigen::VectorXd& x, double t) {
  Eigen::VectorXd y(x.size() + 1);
  y << x, t;
  return y;
}

/// The equations of a curve: as many as unknowns x. y: x, then t.
template <class F>
concept EquationFamily = requires(F family, const F& known, double t, int n, const Eigen::VectorXd& y,
                                  Eigen::Ref<Eigen::VectorXd> f, Eigen::MatrixXd& matrix) {
  { known.unknowns() } -> std::same_as<int>;
  /// Where the curve begins.
  { known.start() } -> std::same_as<Eigen::VectorXd>;
  family.residual(y, f);
  /// The same, right but for the last rounding also where it is small.
  family.wide_residual(y, f);
  /// [dF/dx, dF/dt] at y into the first rows; others may be set to 0.
  family.jacobian(y, matrix);
  /// Of series in s whose coefficients are about to be set: t at s = 0, after the Jacobian was asked for there.
  family.start_series(t);
  /// Coefficient n of y, n = 1, 2, …
  family.set(n, y);
  /// Minus the n-th coefficient of F without what is linear in the n-th coefficient of y. Precondition: set up to n − 1.
  family.known(n, f);
  /// As SeriesCurve says.
  { known.shortest_length(t) } -> std::same_as<double>;
};

/// Dense matrices, factorised with the largest pivot of each column.
class PivotedFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix) { lu_.compute(matrix); }
  int determinant_sign() const { return gcs::determinant_sign(lu_); }
  void apply(const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> result) const {
    result = lu_.solve(right);
  }

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

/// `Inverse`: how the bordered matrix [F_x, F_t; tangent] is inverted; SparseInverse where equations have few unknowns.
template <EquationFamily Family, class Inverse = PivotedFactors>
class ImplicitCurve {
 public:
  ImplicitCurve(Family family, double tolerance, Inverse inverse = {})
      : family_(std::move(family)),
        tolerance_(tolerance),
        bordered_(coordinates(), coordinates()),
        inverse_(std::move(inverse)),
        right_side_(coordinates()),
        correction_(coordinates()) {}

  Eigen::Index coordinates() const { return family_.unknowns() + 1; }

  bool start(int orientation, ArcSeries& series) {
    const Eigen::Index m = family_.unknowns();
    const Eigen::VectorXd y = family_.start();
    jacobian(y);
    const Eigen::FullPivLU<Eigen::MatrixXd> full(bordered_.topRows(m));
    ++work_.factorisations;
    if (full.rank() < m) return false;
    Eigen::VectorXd tangent = full.kernel().col(0).normalized();
    if (tangent[m] * orientation < 0) tangent = -tangent;
    factorise(y, tangent);
    side_ = inverse_.determinant_sign();
    expand(y, series);
    return true;
  }

  bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series, bool is_wide) {
    const Eigen::Index m = family_.unknowns();
    right_side_[m] = 0;
    residual(y, right_side_.head(m), is_wide);
    factorise(y, tangent);
    if (inverse_.determinant_sign() != side_) return false;
    CorrectorTest test(tolerance_, is_wide);
    while (true) {
      inverse_.apply(right_side_, correction_);
      y -= correction_;
      ++work_.newton_iterations;
      const CorrectorTest::Verdict verdict = test.judge(correction_.norm(), y.norm());
      if (verdict == CorrectorTest::Verdict::refuse) return false;
      if (verdict == CorrectorTest::Verdict::settled) break;
      if (verdict == CorrectorTest::Verdict::stalled) test.widen();
      residual(y, right_side_.head(m), test.is_wide());
    }
    if (shortest_length(y[m]) < 0) return false;
    if (test.is_wide() && !CorrectorTest::are_arcs_apart(moved_by_rounding(y.norm()), y.norm())) return false;
    if (test.matrix_is_stale()) factorise(y, tangent);
    expand(y, series);
    return true;
  }

  void renew(ArcSeries& series) {
    const Eigen::VectorXd y = series.coefficient(0);
    factorise(y, series.coefficient(1));
    expand(y, series);
  }

  double shortest_length(double t) const { return family_.shortest_length(t); }
  void accept() {}
  void reject() {}
  WorkCounters& work() { return work_; }

  void residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f, bool is_wide) {
    ++work_.evaluations;
    if (is_wide)
      family_.wide_residual(y, f);
    else
      family_.residual(y, f);
  }
  /// Into the first rows of the bordered matrix.
  void jacobian(const Eigen::VectorXd& y) {
    ++work_.jacobians;
    family_.jacobian(y, bordered_);
  }

  const Family& family() const { return family_; }

 private:
  double moved_by_rounding(double size) {
    const Eigen::Index m = family_.unknowns();
    for (Eigen::Index i = 0; i < m; ++i)
      right_side_[i] = rounding_of_equation(i, bordered_.row(i).norm(), size);
    right_side_[m] = 0;
    inverse_.apply(right_side_, correction_);
    return correction_.norm();
  }

  void factorise(const Eigen::VectorXd& y, const Eigen::VectorXd& last_row) {
    jacobian(y);
    bordered_.bottomRows<1>() = last_row.transpose();
    inverse_.compute(bordered_);
    ++work_.factorisations;
  }

  /// Σ over the orders: B c_n = −constant_n with the factorised B = [F_x, F_t; tangent];
  /// see ArcSeries for the last row.
  void expand(const Eigen::VectorXd& y, ArcSeries& series) {
    const Eigen::Index m = family_.unknowns();
    family_.start_series(y[m]);
    series.coefficient(0) = y;
    right_side_.setZero();
    right_side_[m] = 1;
    inverse_.apply(right_side_, series.coefficient(1));
    series.coefficient(1) /= series.coefficient(1).norm();
    for (int n = 2; n <= series.order(); ++n) {
      family_.set(n - 1, series.coefficient(n - 1));
      family_.known(n, right_side_.head(m));
      right_side_[m] = series.arc_length_term(n);
      inverse_.apply(right_side_, series.coefficient(n));
    }
  }

  Family family_;
  double tolerance_;
  Eigen::MatrixXd bordered_;
  Inverse inverse_;
  int side_ = 0;  ///< the sign of the bordered matrix's determinant, on all of the curve
  Eigen::VectorXd right_side_, correction_;
  WorkCounters work_;
};

}  // namespace gcs
