#pragma once
/// The equations of S along a Taylor polynomial c(s) of it, with bounds that hold for |s| ≤ h.
///
/// On c the forms of every product are polynomials, and so is a(t(s)) but for a remainder where a is bent (here for the
/// half square of a quadratic, else in polynomial_length.hpp). Coefficients of the residual nearly vanish up to the
/// order of c, so that the sum of their sizes is a sharp bound. Rounding is enclosed: a sum of floating-point products is
/// off by less than a few units in the last place of the sum of their sizes.

#include <Eigen/Core>
#include <map>
#include <span>
#include <vector>

#include "solvers/proven_paths/path_data.hpp"
#include "solvers/proven_paths/path_equations.hpp"
#include "solvers/proven_paths/polynomial_length.hpp"
#include "solvers/tracking/arc_series.hpp"

namespace gcs {

/// Bounds for |s| ≤ h.
struct TubeBounds {
  double h = 0;
  /// Of the polynomials and of their derivatives, and of the terms of order ≥ 3: all forms, then all a.
  Eigen::ArrayXd size, speed, rest;
  Eigen::ArrayXd form_error, form_speed_error;      ///< of the exact forms on c against the polynomials
  Eigen::ArrayXd terms;                             ///< the sizes of all that an equation adds up
  double time = 0;                                  ///< |t| on c
  double time_speed = 0;                            ///< |dt/ds| on c
  Eigen::ArrayXd value_error;                       ///< of the exact a(t) against the one in floating point
  Eigen::ArrayXd length_error, length_speed_error;  ///< of the exact a(t(s)) against its polynomial
  Eigen::ArrayXd slope, slope_error;        ///< |a'(t(s))| for the exact a, and the error of the computed one
  Eigen::ArrayXd curvature;                 ///< |a''(t)| for t within 1/2 of those on c
  Eigen::ArrayXd pull_rest;                 ///< of the polynomial of g' in s, the terms of order ≥ 3
  Eigen::ArrayXd residual, residual_speed;  ///< |f(c(s))| and |df(c(s))/ds| for the exact equations
};

/// Pairs from `pair` on, of which each is of the next equation.
struct PairRun {
  Eigen::Index pair = 0, equation = 0, length = 0;
};

class TubeSeries {
 public:
  TubeSeries(PathEquations equations, std::vector<EnclosedLength> lengths, int order);

  /// Prepares for the polynomial c (coordinates and then t).
  void expand(const ArcSeries& c);
  /// Bounds on the part |s| ≤ h.
  void bound(double h, TubeBounds& bounds) const;

  Eigen::Index count() const { return equations_.count; }
  Eigen::Index forms() const { return static_cast<Eigen::Index>(equations_.forms.size()); }
  Eigen::Index coordinates() const { return equations_.coordinates(); }
  const PathEquations& equations() const { return equations_; }
  const std::vector<EnclosedLength>& lengths() const { return lengths_; }
  const ArcSeries& curve() const { return curve_; }
  std::span<const EnclosedForm::Term> terms(Eigen::Index form) const {
    const auto i = static_cast<std::size_t>(form);
    return std::span(terms_).subspan(ends_[i], ends_[i + 1] - ends_[i]);
  }
  /// Whether forms are differences of coordinates, whose polynomials are right but for one rounding of each coefficient.
  bool has_differences() const { return has_differences_; }
  /// Of a sum over an equation's products, relative to their sizes.
  double sum_rounding() const { return sum_rounding_; }
  /// How far the coefficient of a form may be from the exact one, with what rounding adds to sums of such terms.
  double coefficient_error(const EnclosedForm::Term& term) const {
    return term.error + form_rounding_ * std::abs(term.coefficient);
  }
  /// Coefficient n of a form.
  double coefficient(Eigen::Index form, int n) const { return polynomials_(form, n); }
  /// Coefficient n ≤ 2 of g', the negative of the equation's derivative by t.
  double pull(Eigen::Index equation, int n) const { return pulls_(equation, n); }
  /// df/dy on c(0), equations × coordinates, and the same with every product by its size.
  Eigen::MatrixXd jacobian() const;
  Eigen::MatrixXd jacobian_sizes() const;
  /// About how large errors of the equations on c(0) are beside each other: what they add up. Of differences all alike.
  Eigen::VectorXd equation_scales() const;
  /// A form at y, and a bound on its error where the exact point is off by `error`.
  double form_at(Eigen::Index form, const Eigen::VectorXd& y) const;
  double form_error_at(Eigen::Index form, const Eigen::VectorXd& y, const Eigen::VectorXd& error) const;

 private:
  void set_forms();
  void set_lengths();
  void set_residuals();
  void set_factors();
  void bound_forms(TubeBounds& bounds) const;
  void bound_terms(TubeBounds& bounds) const;
  void add_least_terms(TubeBounds& bounds) const;
  void bound_lengths(TubeBounds& bounds) const;
  void bound_polynomial_lengths(TubeBounds& bounds) const;
  void bound_residuals(TubeBounds& bounds) const;
  void add_form_errors(TubeBounds& bounds) const;

  PathEquations equations_;
  std::vector<EnclosedLength> lengths_;
  int order_;
  std::vector<EnclosedForm::Term> terms_;  ///< of all forms in turn
  std::vector<std::size_t> ends_{0};       ///< where those of each end, after 0
  bool has_differences_;
  double sum_rounding_, residual_rounding_, form_rounding_;
  ArcSeries curve_;
  Eigen::MatrixXd polynomials_;  ///< (forms + equations) × (order + 1)
  std::vector<PairRun> runs_;
  bool are_squares_;              ///< of all forms in turn, so that those are V and D
  Eigen::MatrixXd left_, right_;  ///< V and D of all pairs, then all a; unused for squares
  Eigen::MatrixXd residuals_;     ///< equations × (2·order + 1)
  Eigen::MatrixXd pulls_;         ///< equations × 3
  std::map<int, PolynomialLength>
      polynomial_lengths_;  ///< by equation; plain ones, and those of a degree above two
};

}  // namespace gcs
