#pragma once
/// A Taylor polynomial of a curve in its arc length s: y(s) = Σ_n c_n s^n, |y'(s)| = 1.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/lanes/column_kernels.hpp"
#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

class ArcSeries {
 public:
  ArcSeries() = default;
  ArcSeries(Eigen::Index coordinates, int order)
      : coefficients_(coordinates, order + 1),
        ones_(Eigen::VectorXd::Ones(order + 1)),
        exponents_(Eigen::VectorXd::LinSpaced(order + 1, 0, order)),
        rates_(coordinates, order + 1),
        products_(coordinates) {}

  int order() const { return static_cast<int>(coefficients_.cols()) - 1; }
  auto coefficient(int n) { return coefficients_.col(n); }
  auto coefficient(int n) const { return coefficients_.col(n); }
  const Eigen::MatrixXd& coefficients() const { return coefficients_; }

  /// y(s).
  void evaluate(double s, Eigen::VectorXd& y) const {
    y.resize(coefficients_.rows());
    kernels_.evaluate(columns_from(0), order() + 1, ones_.data(), s, y.data());
  }

  /// The unit tangent y'(s)/|y'(s)|.
  void tangent(double s, Eigen::VectorXd& direction) const {
    direction.resize(coefficients_.rows());
    kernels_.evaluate(columns_from(1), order(), exponents_.data() + 1, s, direction.data());
    direction /= direction.norm();
  }

  /// What the arc length condition Σ_c y_c'² = 1 leaves for order n once lower orders are known:
  /// 2n·c_1·c_n = −Σ_{i=2}^{n−1} i(n+1−i)·c_i·c_{n+1−i}; this returns c_1·c_n. To be called for n = 2, 3, … in turn.
  double arc_length_term(int n) {
    Eigen::Map<Eigen::VectorXd>(rates_.column(n - 1), products_.size()) = (n - 1) * coefficient(n - 1);
    kernels_.half_convolution(rates_.from(0), 2, n + 1, products_.data());
    return -products_.sum() / n;
  }

  /// The step whose last two terms stay below `tolerance`, so that one vanishing coefficient deceives nobody.
  double step_for(double tolerance) const {
    double step = std::numeric_limits<double>::infinity();
    for (int n = std::max(2, order() - 1); n <= order(); ++n) {
      const double size = norm(n);
      if (size > 0) step = std::min(step, std::pow(tolerance / size, 1.0 / n));
    }
    return step;
  }

  /// An estimate of the radius of convergence: the larger of the last two roots √(|c_(n−2)|/|c_n|). Orders of
  /// the same parity are compared since the others may vanish. Unlike the size of a term it sees a
  /// singularity however weak, if only that is the one that the last coefficients come from. Infinite where
  /// the terms at that distance are the rounding of lower ones. Precondition: order ≥ 4.
  double radius() const {
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    const double noise = rounding * std::max(1.0, norm(0));
    double radius = 0;
    for (int n = order() - 1; n <= order(); ++n) {
      const double size = norm(n), square = norm(n - 2) / size, ratio = std::sqrt(square);
      double term = n % 2 == 0 ? size : size * ratio;  // there: size · ratio^n
      for (int i = 0; i < n / 2; ++i) term *= square;
      radius = std::max(radius, term > noise ? ratio : std::numeric_limits<double>::infinity());
    }
    return radius;
  }

 private:
  /// Of coefficient n, scaled only where squares may leave the range of doubles.
  double norm(int n) const {
    const double norm = coefficients_.col(n).norm();
    return norm > 1e-140 && norm < 1e150 ? norm : coefficients_.col(n).stableNorm();
  }

  DenseColumns columns_from(int n) const {
    return {coefficients_.col(n).data(), coefficients_.rows(), coefficients_.rows()};
  }

  ColumnKernels kernels_ = lane_functions().columns;
  Eigen::MatrixXd coefficients_;
  Eigen::VectorXd ones_, exponents_;
  AlignedColumns rates_;  ///< n·c_n
  Eigen::VectorXd products_;
};

}  // namespace gcs
