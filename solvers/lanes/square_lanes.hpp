#pragma once
/// The distance equations in lanes: value, Jacobian and Taylor series of f_e(x; A(s)), see square_system.hpp.
///
/// With d the differences of coordinates, d = Σ d_k h^k, the coefficients follow from one factorised Jacobian
/// (rows d_0): d_0 · d_k = A_k/2 − (1/2) Σ_{0<a<k} d_a · d_{k−a}

#include <array>
#include <utility>
#include <vector>

#include "solvers/lanes/lane_route.hpp"

namespace gcs::GCS_LANES {

template <class Real>
class SquareEquations {
 public:
  using System = SquareSystem;
  using Number = Complex<Real>;

  SquareEquations(const SquareSystem& system, const Elimination& elimination, int order)
      : system_(system),
        equations_(elimination.equation),
        order_(order),
        difference_(system.differences.size()),
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

  /// At x = series[unknown][0].
  void begin_series(const std::vector<Number>&, Real s) { s_ = s; }

  /// A_k/2 − (1/2) Σ d_a·d_{k−a}, 0 < a < k, of the equations in the order of elimination, from the terms of x up to
  /// k − 1 in series[unknown][order]. Precondition: it was called for all lower k since `begin_series`, or k = 1.
  void right_sides(int k, const std::vector<Number>& series, std::vector<Number>& right) {
    if (k % 2 == 1)
      (this->*convolutions_at(k))(series.data(), right);
    else
      add_last_products(k, series.data(), right);
    if (k > Route::degree) return;
    for (std::size_t i = 0; i < equations_.size(); ++i)
      right[i] = fused(constant(0.5, Real{}), route_.term(equations_[i], k, s_), right[i]);
  }

 private:
  using Convolutions = void (SquareEquations::*)(const Number*, std::vector<Number>&);

  /// `convolutions` for an odd k.
  static Convolutions convolutions_at(int k) {
    static constexpr auto of_halves = []<int... halves>(std::integer_sequence<int, halves...>) {
      return std::array<Convolutions, sizeof...(halves)>{&SquareEquations::convolutions<2 * halves + 1>...};
    };
    static constexpr auto table =
        of_halves(std::make_integer_sequence<int, TrackingOptions::highest_order / 2>{});
    return table[k / 2];
  }

  /// Of two orders at once: right = −(1/2) Σ d_a·d_{k−a}, 0 < a < k, and next_ = (1/2) Σ d_a·d_{k+1−a} but
  /// for what needs d_k. The time goes into loading the terms, and so each is used for both.
  template <int k>
  void convolutions(const Number* series, std::vector<Number>& right) {
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      SplitSum<Real> sum, next;
      for_differences(equations_[i], series,
                      [&](const auto& difference) { add_products<k>(difference, sum, next); });
      right[i] = -sum.value();
      next_[i] = next.value();
    }
  }

  /// The products d_a·d_b, a ≤ b, with a + b = k and then k + 1 in turn: each has a factor of the one before.
  template <int k, class Terms>
  static void add_products(const Terms& d, SplitSum<Real>& sum, SplitSum<Real>& next) {
    static_assert(k % 2 == 1);
    const Real half = constant(0.5, Real{});
    [&]<int... is>(std::integer_sequence<int, is...>) {
      [[maybe_unused]] const auto add = [&]<int a, int b>(std::integral_constant<int, a>,
                                                          std::integral_constant<int, b>) {
        sum.add_product(d(a), d(b));
        next.add_product(a + 1 == b ? half * d(b) : d(a + 1), d(b));
      };
      (add(std::integral_constant<int, is + 1>{}, std::integral_constant<int, k - 1 - is>{}), ...);
    }
    (std::make_integer_sequence<int, k / 2>{});
  }

  /// right = −next_ − (the products that need d_{k−1}), k even.
  void add_last_products(int k, const Number* series, std::vector<Number>& right) {
    const Real factor = constant(k == 2 ? 0.5 : 1, Real{});
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      Number sum = next_[i];
      for_differences(equations_[i], series,
                      [&](const auto& d) { sum = fused(factor * d(1), d(k - 1), sum); });
      right[i] = -sum;
    }
  }

  /// Calls `use` with each difference of an equation, a function from k > 0 to the coefficient d_k.
  template <class Use>
  void for_differences(int equation, const Number* series, const Use& use) const {
    for (int d = system_.first[equation]; d < system_.first[equation + 1]; ++d) {
      const Number* u = series + system_.differences[d].minuend * (order_ + 1);
      const int subtrahend = system_.differences[d].subtrahend;
      if (subtrahend < 0)
        use([u](int k) { return u[k]; });
      else
        use([u, v = series + subtrahend * (order_ + 1)](int k) { return u[k] - v[k]; });
    }
  }

  Number difference(std::size_t d, const std::vector<Number>& x) const {
    const auto [minuend, subtrahend, value] = system_.differences[d];
    return x[minuend] - (subtrahend >= 0 ? x[subtrahend] : Number{constant(value, Real{}), Real{}});
  }

  const SquareSystem& system_;
  const std::vector<int>& equations_;  ///< in the order of elimination
  const int order_;
  std::vector<std::array<int, 2>> entries_of_;  ///< of a difference's minuend and subtrahend (−1: none)
  std::vector<int> entries_of_linear_;
  std::vector<Number> difference_;
  Real s_;  ///< of the series
  LaneRoute<Real> route_;
  std::vector<Number> squares_;
  std::vector<Number> next_ = std::vector<Number>(squares_.size());  ///< see convolutions
};

}  // namespace gcs::GCS_LANES
