#pragma once
/// Sparse equations in lanes: value, Jacobian and Taylor series of f_e(x; c(s)), see monomial_system.hpp. The
/// series of a coefficient times that of a sum of monomials is a convolution; what several equations have of these sums is
/// taken once, and so is their value in two doubles.

#include <algorithm>
#include <array>
#include <vector>

#include "solvers/lanes/lane_route.hpp"

namespace gcs::GCS_LANES {

template <class Real>
class MonomialEquations {
 public:
  using System = MonomialSystem;
  using Number = Complex<Real>;

  MonomialEquations(const MonomialSystem& system, const Elimination& elimination, int order)
      : order_(order),
        parts_(monomial_sums(system)),
        elimination_(elimination),
        coefficient_(parts_.terms.size()),
        sums_(parts_.sums.size()),
        series_of_sums_(parts_.sums.size() * (order + 1)),
        coefficients_(parts_.terms.size() * (order + 1)),
        route_(system.monomials.size()) {
    list_parts_of_sums();
    list_derivatives();
    schedule();
  }

  void load(int lane, const Route& route) { route_.load(lane, route); }

  /// The coefficients at s, where `arriving` is not 0 those of the end; the Jacobian at x goes into
  /// `entries`, which come as 0.
  void evaluate(const std::vector<Number>& x, Real s, Real arriving, std::vector<Number>& entries) {
    for (std::size_t m = 0; m < sums_.size(); ++m) sums_[m] = sum_at(parts_.sums[m], x);
    for (std::size_t t = 0; t < coefficient_.size(); ++t)
      coefficient_[t] = route_.value(parts_.terms[t].coefficient, s, arriving);
    for (const auto& [entry, term, factor] : derivatives_) {
      const Number& c = coefficient_[term];
      entries[entry] = factor < 0 ? entries[entry] + c : fused(c, x[factor], entries[entry]);
    }
  }

  /// f_e at the x that was evaluated last, right to the rounding of x and of the coefficients.
  Number residual(int e, const std::vector<Number>&) const {
    Compensated<Real> re, im;
    for (int t = parts_.first[e]; t < parts_.first[e + 1]; ++t) {
      const Number& c = coefficient_[t];
      const Sum& sum = sums_[parts_.terms[t].sum];
      add_product(c, Number{sum.re.high, sum.im.high}, re, im);
      const Number low = product(c, Number{sum.re.low, sum.im.low});
      re.low = re.low + low.re;
      im.low = im.low + low.im;
    }
    return {re.value(), im.value()};
  }

  /// At x = series[unknown][0], with the coefficients at s, where they were evaluated last.
  void begin_series(const std::vector<Number>& series, Real s) {
    if (route_.moving() != scheduled_) schedule();
    for (const Summand& summand : summands_)
      if (summand.moves)
        route_.series(parts_.terms[summand.term].coefficient, s, order_,
                      &coefficients_[summand.term * (order_ + 1)]);
    const auto x = [&](int i) { return series[i * (order_ + 1)]; };
    Number* sum = terms_of_sums(0);
    std::fill_n(sum, parts_.sums.size(), Number{});
    for (const Part& part : constants_) sum[part.sum].re = sum[part.sum].re + constant(1, Real{});
    for (const Part& part : unknowns_) sum[part.sum] = sum[part.sum] + x(part.u);
    for (const std::vector<Part>* parts : {&products_, &squares_})
      for (const Part& part : *parts) sum[part.sum] = fused(x(part.u), x(part.v), sum[part.sum]);
  }

  /// What the k-th terms of the equations lack for 0, with the sign turned, in the order of elimination, from the terms
  /// of x up to k − 1 in series[unknown][order]. Precondition: it was called for all lower k since `begin_series`, or
  /// k = 1.
  void right_sides(int k, const std::vector<Number>& series, std::vector<Number>& right) {
    if (k > 1) extend_sums(k - 1, series);
    Number* known = terms_of_sums(k);
    std::fill_n(known, parts_.sums.size(), Number{});
    for (const Part& part : products_)
      known[part.sum] = known[part.sum] + inner_terms(terms_of(part.u, series), terms_of(part.v, series), k);
    for (const Part& part : squares_)
      known[part.sum] = known[part.sum] + inner_terms(terms_of(part.u, series), k);
    std::fill_n(right.begin(), elimination_.equation.size(), Number{});
    for (const Summand& summand : summands_) {
      Number& sum = right[summand.place];
      sum = summand.moves ? less_convolution(sum, summand, k)
                          : fused_minus(coefficient_[summand.term], known[summand.sum], sum);
    }
  }

 private:
  /// In twice the precision.
  struct Sum {
    Compensated<Real> re, im;
  };
  /// A monomial x_u·x_v, x_u or 1 of a sum.
  struct Part {
    int sum = 0;
    int u = -1, v = -1;
  };
  /// Of a term, c·x_factor or c, to be added to an entry of the Jacobian.
  struct Derivative {
    int entry = 0, term = 0;
    int factor = -1;
  };
  /// A term of the equation that is eliminated at step `place`.
  struct Summand {
    int place = 0, term = 0, sum = 0;
    bool moves = false;
  };

  void list_parts_of_sums() {
    for (int m = 0; m < static_cast<int>(parts_.sums.size()); ++m)
      for (const auto& [u, v] : parts_.sums[m]) {
        std::vector<Part>& alike = u < 0 ? constants_ : (v < 0 ? unknowns_ : (u == v ? squares_ : products_));
        alike.push_back({m, u, v});
      }
  }

  void list_derivatives() {
    for (int e = 0; e + 1 < static_cast<int>(parts_.first.size()); ++e)
      for (int t = parts_.first[e]; t < parts_.first[e + 1]; ++t)
        for (const auto& [u, v] : parts_.sums[parts_.terms[t].sum]) {
          if (u >= 0) derivatives_.push_back({elimination_.entry(e, u), t, v});
          if (v >= 0) derivatives_.push_back({elimination_.entry(e, v), t, u});
        }
  }

  /// A term of each equation in turn: sums of different equations do not wait for each other. Left out is what rests and
  /// has no products: its k-th terms are what is looked for. The order does not depend on what moves.
  void schedule() {
    scheduled_ = route_.moving();
    summands_.clear();
    const auto equations = static_cast<int>(elimination_.equation.size());
    for (int turn = 0, left = 1; left > 0; ++turn) {
      left = 0;
      for (int place = 0; place < equations; ++place) {
        const int e = elimination_.equation[place], t = parts_.first[e] + turn;
        if (t >= parts_.first[e + 1]) continue;
        ++left;
        const auto [coefficient, sum] = parts_.terms[t];
        const bool moves = route_.moves(coefficient);
        if (moves || has_products(parts_.sums[sum])) summands_.push_back({place, t, sum, moves});
      }
    }
  }

  static bool has_products(const std::vector<Monomial>& sum) {
    return std::any_of(sum.begin(), sum.end(), [](const Monomial& monomial) { return monomial.v >= 0; });
  }

  static Sum sum_at(const std::vector<Monomial>& monomials, const std::vector<Number>& x) {
    Sum sum;
    for (const auto& [u, v] : monomials) {
      if (v >= 0) {
        add_product(x[u], x[v], sum.re, sum.im);
      } else {
        sum.re.add(u < 0 ? constant(1, Real{}) : x[u].re);
        sum.im.add(u < 0 ? Real{} : x[u].im);
      }
    }
    return sum;
  }

  /// The k-th coefficients of the series of all sums.
  Number* terms_of_sums(int k) { return &series_of_sums_[k * parts_.sums.size()]; }
  const Number* terms_of_sums(int k) const { return &series_of_sums_[k * parts_.sums.size()]; }
  const Number* terms_of(int unknown, const std::vector<Number>& series) const {
    return &series[unknown * (order_ + 1)];
  }

  /// `sum` less the k-th coefficient of a term's series.
  Number less_convolution(Number sum, const Summand& of, int k) const {
    const Number* c = &coefficients_[of.term * (order_ + 1)];
    const int terms = route_.has_rates() ? k : std::min(k, Route::degree);
    for (int a = terms; a >= 0; --a) sum = fused_minus(c[a], terms_of_sums(k - a)[of.sum], sum);
    return sum;
  }

  /// The k-th coefficients of the sums, from those of x.
  void extend_sums(int k, const std::vector<Number>& series) {
    Number* sum = terms_of_sums(k);
    for (const Part& part : unknowns_) sum[part.sum] = sum[part.sum] + terms_of(part.u, series)[k];
    for (const std::vector<Part>* parts : {&products_, &squares_})
      for (const Part& part : *parts) {
        const Number *x = terms_of(part.u, series), *y = terms_of(part.v, series);
        sum[part.sum] = fused(x[0], y[k], fused(x[k], y[0], sum[part.sum]));
      }
  }

  /// Σ_{0<a<k} x_a·y_{k−a}
  static Number inner_terms(const Number* x, const Number* y, int k) {
    Number sum{};
    for (int i = 1; i < k; ++i) sum = fused(x[i], y[k - i], sum);
    return sum;
  }
  /// The same with y = x.
  static Number inner_terms(const Number* x, int k) {
    Number sum{};
    for (int i = 1; 2 * i < k; ++i) sum = fused(x[i], x[k - i], sum);
    sum = sum + sum;
    return k % 2 == 0 ? fused(x[k / 2], x[k / 2], sum) : sum;
  }

  const int order_;
  const MonomialSums parts_;
  const Elimination& elimination_;
  std::vector<Part> constants_, unknowns_, squares_, products_;  ///< of all sums
  std::vector<Derivative> derivatives_;
  std::vector<Summand> summands_;
  std::size_t scheduled_ = 0;           ///< parameters that moved when the summands were put in order
  std::vector<Number> coefficient_;     ///< of a term
  std::vector<Sum> sums_;               ///< at the x that was evaluated last
  std::vector<Number> series_of_sums_;  ///< [order][sum]
  std::vector<Number> coefficients_;    ///< [term][order], of what moves
  LaneRoute<Real> route_;
};

}  // namespace gcs::GCS_LANES
