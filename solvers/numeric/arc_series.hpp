#pragma once
/// A Taylor polynomial of a curve in its arc length s: y(s) = Σ_n c_n s^n, |y'(s)| = 1.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {

class ArcSeries {
 public:
  ArcSeries() = default;
  ArcSeries(Eigen::Index coordinates, int order) : coefficients_(coordinates, order + 1) {}

  int order() const { return static_cast<int>(coefficients_.cols()) - 1; }
  auto coefficient(int n) { return coefficients_.col(n); }
  auto coefficient(int n) const { return coefficients_.col(n); }
  const Eigen::MatrixXd& coefficients() const { return coefficients_; }

  /// y(s), by Horner's rule.
  void evaluate(double s, Eigen::VectorXd& y) const {
    y = coefficients_.col(order());
    for (int n = order() - 1; n >= 0; --n) y = y * s + coefficients_.col(n);
  }

  /// The unit tangent y'(s)/|y'(s)|.
  void tangent(double s, Eigen::VectorXd& direction) const {
    direction = order() * coefficients_.col(order());
    for (int n = order() - 1; n >= 1; --n) direction = direction * s + n * coefficients_.col(n);
    direction /= direction.norm();
  }

  /// What the arc length condition Σ_c y_c'² = 1 leaves for order n ≥ 2 once lower orders are known:
  /// 2n·c_1·c_n = −Σ_{i=2}^{n−1} i(n+1−i)·c_i·c_{n+1−i}; this returns c_1·c_n.
  double arc_length_term(int n) const {
    double sum = 0;
    for (int i = 2; 2 * i <= n + 1; ++i) {
      const double weight = (2 * i == n + 1 ? 1.0 : 2.0) * i * (n + 1 - i);
      sum += weight * coefficients_.col(i).dot(coefficients_.col(n + 1 - i));
    }
    return -sum / (2 * n);
  }

  /// The step whose last two terms stay below `tolerance`, so that one vanishing coefficient deceives nobody.
  double step_for(double tolerance) const {
    double step = std::numeric_limits<double>::infinity();
    for (int n = std::max(2, order() - 1); n <= order(); ++n) {
      const double size = coefficients_.col(n).stableNorm();
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
    const double noise = rounding * std::max(1.0, coefficients_.col(0).stableNorm());
    double radius = 0;
    for (int n = order() - 1; n <= order(); ++n) {
      const double size = coefficients_.col(n).stableNorm();
      const double ratio = std::sqrt(coefficients_.col(n - 2).stableNorm() / size);
      const bool shows = size * std::pow(ratio, n) > noise;
      radius = std::max(radius, shows ? ratio : std::numeric_limits<double>::infinity());
    }
    return radius;
  }

 private:
  Eigen::MatrixXd coefficients_;
};

}  // namespace gcs
