#pragma once
/// Sparse equations in lanes: value, Jacobian and Taylor series of f_e(x; c(s)), see monomial_system.hpp. The
/// series of a monomial's coefficient times that of its product of unknowns is a convolution.

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
      : system_(system),
        order_(order),
        distinct_(distinct_monomials(system)),
        coefficient_(system.monomials.size()),
        products_(distinct_.monomials.size() * (order + 1)),
        coefficients_(system.monomials.size() * (order + 1)),
        route_(system.monomials.size()) {
    for (int e = 0; e < system.equations(); ++e)
      for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
        const auto [u, v] = system.monomials[j];
        entries_of_.push_back({entry(elimination, e, u), entry(elimination, e, v)});
      }
  }

  void load(int lane, const Route& route) { route_.load(lane, route); }

  /// The coefficients at s, where `arriving` is not 0 those of the end; the Jacobian at x goes into
  /// `entries`, which come as 0.
  void evaluate(const std::vector<Number>& x, Real s, Real arriving, std::vector<Number>& entries) {
    for (std::size_t j = 0; j < coefficient_.size(); ++j) {
      coefficient_[j] = route_.value(j, s, arriving);
      const auto [u, v] = system_.monomials[j];
      const auto [by_u, by_v] = entries_of_[j];
      if (u >= 0)
        entries[by_u] = v < 0 ? entries[by_u] + coefficient_[j] : fused(coefficient_[j], x[v], entries[by_u]);
      if (v >= 0) entries[by_v] = fused(coefficient_[j], x[u], entries[by_v]);
    }
  }

  /// f_e at the x that was evaluated last, right to the rounding of x and of the coefficients.
  Number residual(int e, const std::vector<Number>& x) const {
    Compensated<Real> re, im;
    for (int j = system_.first[e]; j < system_.first[e + 1]; ++j) {
      const auto [u, v] = system_.monomials[j];
      const Number& c = coefficient_[j];
      if (u < 0) {
        re.add(c.re);
        im.add(c.im);
      } else if (v < 0) {
        add_product(c, x[u], re, im);
      } else {
        Compensated<Real> product_re, product_im;
        add_product(x[u], x[v], product_re, product_im);
        add_product(c, Number{product_re.high, product_im.high}, re, im);
        const Number low = product(c, Number{product_re.low, product_im.low});
        re.low = re.low + low.re;
        im.low = im.low + low.im;
      }
    }
    return {re.value(), im.value()};
  }

  /// At x = series[unknown][0].
  void begin_series(const std::vector<Number>& series, Real s) {
    for (std::size_t j = 0; j < coefficient_.size(); ++j)
      route_.series(j, s, order_, &coefficients_[j * (order_ + 1)]);
    const auto x = [&](int i) { return series[i * (order_ + 1)]; };
    for (std::size_t m = 0; m < distinct_.monomials.size(); ++m) {
      const auto [u, v] = distinct_.monomials[m];
      products_[m * (order_ + 1)] =
          u < 0 ? Number{constant(1, Real{}), Real{}} : (v < 0 ? x(u) : product(x(u), x(v)));
    }
  }

  /// What the k-th terms of these f_e lack for 0, with the sign turned, in their order, from the terms of x
  /// up to k − 1 in series[unknown][order]. Precondition: it was called for all lower k since `begin_series`,
  /// or k = 1.
  void right_sides(int k, const std::vector<int>& equations, const std::vector<Number>& series,
                   std::vector<Number>& right) {
    if (k > 1) extend_products(k - 1, series);
    for (std::size_t m = 0; m < distinct_.monomials.size(); ++m) {
      const auto [u, v] = distinct_.monomials[m];
      products_[m * (order_ + 1) + k] = v < 0 ? Number{} : inner_terms(u, v, k, series);
    }
    std::fill_n(right.begin(), equations.size(), Number{});
    // A term of each equation in turn: sums of different equations do not wait for each other.
    for (int place = 0, left = 1; left > 0; ++place) {
      left = 0;
      for (std::size_t i = 0; i < equations.size(); ++i) {
        const int j = system_.first[equations[i]] + place;
        if (j >= system_.first[equations[i] + 1]) continue;
        right[i] = less_term(right[i], j, k);
        ++left;
      }
    }
  }

 private:
  /// `sum` less the k-th coefficient of term j's series.
  Number less_term(Number sum, int j, int k) const {
    const Number* c = &coefficients_[j * (order_ + 1)];
    const Number* p = &products_[distinct_.numbers[j] * (order_ + 1)];
    // At rest its first coefficient is all, and the k-th term of an unknown is not known yet.
    if (!route_.moves(j)) return system_.monomials[j].v < 0 ? sum : fused_minus(c[0], p[k], sum);
    const int terms = route_.has_rates() ? k : std::min(k, Route::degree);
    for (int a = terms; a >= 0; --a) sum = fused_minus(c[a], p[k - a], sum);
    return sum;
  }

  /// The k-th terms of the products, from those of x.
  void extend_products(int k, const std::vector<Number>& series) {
    for (std::size_t m = 0; m < distinct_.monomials.size(); ++m) {
      const auto [u, v] = distinct_.monomials[m];
      if (u < 0) continue;
      Number& p = products_[m * (order_ + 1) + k];
      const Number* x = &series[u * (order_ + 1)];
      const Number* y = v < 0 ? nullptr : &series[v * (order_ + 1)];
      p = y ? fused(x[0], y[k], fused(x[k], y[0], p)) : x[k];
    }
  }

  static int entry(const Elimination& elimination, int e, int i) {
    return i < 0 ? -1 : elimination.entry(e, i);
  }

  /// Σ_{0<a<k} u_a·v_{k−a}
  Number inner_terms(int u, int v, int k, const std::vector<Number>& series) const {
    const Number* a = &series[u * (order_ + 1)];
    const Number* b = &series[v * (order_ + 1)];
    Number sum{};
    if (u != v) {
      for (int i = 1; i < k; ++i) sum = fused(a[i], b[k - i], sum);
      return sum;
    }
    for (int i = 1; 2 * i < k; ++i) sum = fused(a[i], a[k - i], sum);
    sum = sum + sum;
    return k % 2 == 0 ? fused(a[k / 2], a[k / 2], sum) : sum;
  }

  const MonomialSystem& system_;
  const int order_;
  std::vector<std::array<int, 2>> entries_of_;  ///< of a monomial's derivatives by u and v (−1: none)
  const DistinctMonomials distinct_;
  std::vector<Number> coefficient_;
  std::vector<Number> products_;      ///< [distinct monomial][order]
  std::vector<Number> coefficients_;  ///< [monomial][order]
  LaneRoute<Real> route_;
};

}  // namespace gcs::GCS_LANES
