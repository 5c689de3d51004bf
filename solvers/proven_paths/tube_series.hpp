#pragma once
/// The distance equations along a Taylor polynomial c(s) of S, with bounds that hold for |s| ≤ h.
///
/// On c the coordinates' differences Δ(s) of every edge are polynomials, and so is a(t(s)) but for a
/// remainder where a is bent (here for a quadratic, else in polynomial_length.hpp). The equation (|Δ|² − a²)/2 is thus quadratic in dimension + 1 polynomials, a
/// being one more coordinate of negative sign: "axis" below runs over the coordinates' axes and then the
/// length. Coefficients of the residual nearly vanish up to the order of c, so that the sum of their sizes is
/// a sharp bound. Rounding is enclosed: a sum of floating-point products is off by less than a few units in
/// the last place of the sum of their sizes.

#include <Eigen/Core>
#include <map>
#include <vector>

#include "solvers/numeric/arc_series.hpp"
#include "solvers/proven_paths/path_data.hpp"
#include "solvers/proven_paths/polynomial_length.hpp"

namespace gcs {

/// Bounds for |s| ≤ h; entry axis · edges + edge, or one per edge.
struct TubeBounds {
  double h = 0;
  Eigen::ArrayXd size, speed;                       ///< of the polynomials and of their derivatives
  Eigen::ArrayXd rest;                              ///< of their terms of order ≥ 3
  double time = 0;                                  ///< |t| on c
  double time_speed = 0;                            ///< |dt/ds| on c
  Eigen::ArrayXd value_error;                       ///< of the exact a(t) against the one in floating point
  Eigen::ArrayXd length_error, length_speed_error;  ///< of the exact a(t(s)) against its polynomial
  Eigen::ArrayXd slope, slope_error;        ///< |a'(t(s))| for the exact a, and the error of the computed one
  Eigen::ArrayXd curvature;                 ///< |a''(t)| for t within 1/2 of those on c
  Eigen::ArrayXd pull_rest;                 ///< of the polynomial of a·a' in s, the terms of order ≥ 3
  Eigen::ArrayXd residual, residual_speed;  ///< |f(c(s))| and |df(c(s))/ds| for the exact equations
};

class TubeSeries {
 public:
  TubeSeries(const DistanceSystem& system, std::vector<EnclosedLength> lengths, int order);

  /// Prepares for the polynomial c (coordinates and then t).
  void expand(const ArcSeries& c);
  /// Bounds on the part |s| ≤ h.
  void bound(double h, TubeBounds& bounds) const;

  int edges() const { return system_.equations(); }
  int axes() const { return system_.dimension(); }
  int coordinates() const { return system_.unknowns() + 1; }
  const DistanceSystem& system() const { return system_; }
  const std::vector<EnclosedLength>& lengths() const { return lengths_; }
  const ArcSeries& curve() const { return curve_; }
  /// The two coordinates whose difference is that of an edge along an axis; coordinates() where the frame has
  /// a zero.
  std::array<int, 2> ends(int axis, int edge) const;
  /// Coefficient n of Δ (axis < axes()) or of a.
  double coefficient(int axis, int edge, int n) const { return polynomials_(axis * edges() + edge, n); }
  /// Coefficient n ≤ 2 of a·a', the negative of the equation's derivative by t.
  double pull(int edge, int n) const { return pulls_(edge, n); }
  /// df/dy on c(0), edges × coordinates.
  Eigen::MatrixXd jacobian() const;

 private:
  void set_differences();
  void set_lengths();
  void set_residuals();
  void bound_lengths(TubeBounds& bounds) const;
  void bound_polynomial_lengths(TubeBounds& bounds) const;
  void bound_residuals(TubeBounds& bounds) const;

  DistanceSystem system_;
  std::vector<EnclosedLength> lengths_;
  int order_;
  ArcSeries curve_;
  Eigen::MatrixXd polynomials_;                         ///< (axes + 1)·edges × (order + 1)
  Eigen::MatrixXd residuals_;                           ///< edges × (2·order + 1)
  Eigen::MatrixXd pulls_;                               ///< edges × 3
  std::map<int, PolynomialLength> polynomial_lengths_;  ///< by edge; those of a degree above two
};

}  // namespace gcs
