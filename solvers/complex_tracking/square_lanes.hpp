#pragma once
/// The distance equations in lanes: value, Jacobian and Taylor series of f_e(x; A(s)), see square_system.hpp.
///
/// With d the differences of coordinates, d = Σ d_k h^k, the coefficients follow from one factorised Jacobian
/// (rows d_0): d_0 · d_k = A_k/2 − (1/2) Σ_{0<a<k} d_a · d_{k−a}

#include <array>
#include <vector>

#include "solvers/complex_tracking/lane_route.hpp"

namespace gcs::GCS_LANES {

template <class Real>
class SquareEquations {
 public:
  using System = SquareSystem;
  using Number = Complex<Real>;

  SquareEquations(const SquareSystem& system, const Elimination& elimination, int order)
      : system_(system),
        order_(order),
        difference_(system.differences.size()),
        series_(system.differences.size() * (order + 1)),
        route_(system.given.size()),
        squares_(system.given.size()) {
    for (int e = 0; e < system.equations(); ++e) {
      for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
        const auto [minuend, subtrahend, value] = system.differences[d];
        entries_of_.push_back(
            {elimination.entry(e, minuend), subtrahend >= 0 ? elimination.entry(e, subtrahend) : -1});
      }
      for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
        entries_of_linear_.push_back(elimination.entry(e, system.linear[l].unknown));
    }
  }

  void load(int lane, const Route& route) { route_.load(lane, route); }

  /// The differences at x and the parameters at s, where `arriving` is not 0 those of the end; the Jacobian
  /// goes into `entries`, which come as 0.
  void evaluate(const std::vector<Number>& x, Real s, Real arriving, std::vector<Number>& entries) {
    for (std::size_t d = 0; d < difference_.size(); ++d) {
      difference_[d] = difference(d, x);
      entries[entries_of_[d][0]] = difference_[d];
      if (entries_of_[d][1] >= 0) entries[entries_of_[d][1]] = -difference_[d];
    }
    for (std::size_t l = 0; l < system_.linear.size(); ++l)
      entries[entries_of_linear_[l]] = number(0.5 * system_.linear[l].coefficient, Real{});
    for (std::size_t e = 0; e < squares_.size(); ++e) squares_[e] = route_.value(e, s, arriving);
  }

  /// (Σ d² + Σ c·w − A)/2, at the x that was evaluated last, right to its rounding.
  Number residual(int e, const std::vector<Number>& x) const {
    Compensated<Real> re, im;
    for (int d = system_.first[e]; d < system_.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, value] = system_.differences[d];
      const Number& u = x[minuend];
      const Number v = subtrahend >= 0 ? x[subtrahend] : Number{constant(value, Real{}), Real{}};
      const Number& high = difference_[d];
      const Number low{lost(u.re, v.re, high.re), lost(u.im, v.im, high.im)};
      const Real two_re = high.re + high.re, two_im = high.im + high.im;
      re.add_product(high.re, high.re);
      re.add_product(-high.im, high.im);
      re.low = fused_minus(two_im, low.im, fused(two_re, low.re, re.low));
      im.add_product(two_re, high.im);
      im.low = fused(two_im, low.re, fused(two_re, low.im, im.low));
    }
    for (int l = system_.first_linear[e]; l < system_.first_linear[e + 1]; ++l) {
      const auto& [unknown, coefficient] = system_.linear[l];
      add_product(number(coefficient, Real{}), x[unknown], re, im);
    }
    re.add(constant(system_.given[e], Real{}));
    re.add(-squares_[e].re);
    im.add(-squares_[e].im);
    const Real half = constant(0.5, Real{});
    return {half * re.value(), half * im.value()};
  }

  /// The series of the differences begin at x.
  void begin_series(const std::vector<Number>& x, Real s) {
    for (std::size_t d = 0; d < difference_.size(); ++d) series_[d * (order_ + 1)] = difference(d, x);
    s_ = s;
  }

  /// A_k/2 − (1/2) Σ d_a · d_{k−a} of equation e.
  Number right_side(int e, int k) const {
    Number sum = constant(0.5, Real{}) * route_.term(e, k, s_);
    Number middle{};
    for (int d = system_.first[e]; d < system_.first[e + 1]; ++d) {
      const Number* c = &series_[d * (order_ + 1)];
      SplitSum<Real> products;
      for (int a = 1; 2 * a < k; ++a) products.add_product(c[a], c[k - a]);
      sum = sum - products.value();
      if (k % 2 == 0) middle = fused(c[k / 2], c[k / 2], middle);
    }
    return fused(constant(-0.5, Real{}), middle, sum);
  }

  /// The k-th terms of the differences, from those of x.
  void extend_series(int k, const std::vector<Number>& x) {
    for (std::size_t d = 0; d < difference_.size(); ++d) {
      const auto [minuend, subtrahend, value] = system_.differences[d];
      series_[d * (order_ + 1) + k] = subtrahend >= 0 ? x[minuend] - x[subtrahend] : x[minuend];
    }
  }

 private:
  Number difference(std::size_t d, const std::vector<Number>& x) const {
    const auto [minuend, subtrahend, value] = system_.differences[d];
    return x[minuend] - (subtrahend >= 0 ? x[subtrahend] : Number{constant(value, Real{}), Real{}});
  }

  const SquareSystem& system_;
  const int order_;
  std::vector<std::array<int, 2>> entries_of_;  ///< of a difference's minuend and subtrahend (−1: none)
  std::vector<int> entries_of_linear_;
  std::vector<Number> difference_;
  std::vector<Number> series_;  ///< [difference][order]
  Real s_;                      ///< of the series
  LaneRoute<Real> route_;
  std::vector<Number> squares_;
};

}  // namespace gcs::GCS_LANES
