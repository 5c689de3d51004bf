#pragma once
/// A length a(t) of any degree along a Taylor polynomial t(s) of S, with bounds that hold for |s| ≤ h.
///
/// With τ(s) = t(s) − t(0) and the expansion a(t(0) + τ) = Σ α_k τ^k, a(t(s)) and a'(t(s)) are polynomials in s but
/// for what the powers of τ have beyond the order. Bounds come from the sizes of all terms, by |τ| ≤ Σ |t_n| h^n.

#include <Eigen/Core>
#include <vector>

#include "solvers/proven_paths/path_data.hpp"

namespace gcs {

/// For |s| ≤ h, as in TubeBounds.
struct LengthBounds {
  double value_error = 0;  ///< of the exact a(t) against LengthPath::value, for |t − t(s)| ≤ 1
  double length_error = 0, length_speed_error = 0;  ///< of the exact a(t(s)) and its derivative by s
  double slope = 0, slope_error = 0;  ///< |a'(t(s))| for the exact a, and against its polynomial
  double curvature = 0;               ///< |a''(t)| for |t − t(s)| ≤ 1/2
  double pull_rest = 0;  ///< of the polynomial that PolynomialLength::pull begins, the terms of order ≥ 3
};

class PolynomialLength {
 public:
  PolynomialLength(const EnclosedLength& length, int order) : length_(length), order_(order) {}

  bool is_plain() const { return length_.is_plain; }
  /// Expands along the polynomial with these coefficients, as many as the order and one.
  void expand(const Eigen::VectorXd& t);
  /// Coefficients of a(t(s)) and of a'(t(s)), cut off at the order.
  const Eigen::VectorXd& value() const { return value_; }
  const Eigen::VectorXd& slope() const { return slope_; }
  /// Coefficients 0, 1 and 2 of the product of both or, of a plain length, of a'(t(s)).
  Eigen::RowVector3d pull() const;
  LengthBounds bound(double h) const;

 private:
  EnclosedLength length_;
  int order_;
  Eigen::VectorXd t_, value_, slope_;
  std::vector<double> expansion_, errors_;  ///< α_k, and how far the exact ones may be from them
};

}  // namespace gcs
