#pragma once
/// What a Taylor series lacks behind its last coefficient, in lanes: Σ x_k h^k is continued as a rational
/// function of h whose denominator D(h) = 1 + q_1 h + q_2 h² is common to all components, as the poles and
/// branch points of a path are. q makes |x_N + q_1 x_{N−1} + q_2 x_{N−2}| as small as it can be (the vector
/// Padé approximants SMPE of A. Sidi, Rational approximations from power series of vector-valued meromorphic
/// functions, J. Approx. Theory 77 (1994)). With x_k = −q_1 x_{k−1} − q_2 x_{k−2} for all k > N the sum is
///   Σ_{k<N−1} x_k h^k + (x_{N−1} (1 + q_1 h) + x_N h) h^{N−1}/D(h).
///
/// Two poles: of the order 12 a path's next two branch points matter, and a third pole would fit rounding.

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solvers/lanes/complex_lanes.hpp"

namespace gcs::GCS_LANES {

template <class Real>
class SeriesTail {
 public:
  using Number = Complex<Real>;

  /// From the terms x_0 … x_N, N ≥ 3, of every component: series[component·(N + 1) + k]. What no denominator
  /// fits, and what is so large or small that its square is no number, is continued by zeros.
  void fit(const std::vector<Number>& series, int order) {
    misfit_ = distance(series, order, denominator(series, order, order - 1));
    q_ = denominator(series, order, order);
  }

  /// How well a denominator fitted to x_{N−1} foretells x_N: the largest component of the difference. With
  /// the one fitted to x_N the sum at h is in error by about misfit·h^N/|D(h)|.
  Real misfit() const { return misfit_; }

  /// Replaces x_N h + x_{N−1} in Horner's scheme by what is up there: (x_{N−1} (1 + q_1 h) + x_N h)/D(h).
  struct Weights {
    Number last;          ///< of x_N
    Number last_but_one;  ///< of x_{N−1}
  };
  Weights weights(Real h) const {
    const Number one{constant(1, Real{}), Real{}};
    const Number first = fused(h, q_[0], one);
    const Number inverse_denominator = inverse(fused(h * h, q_[1], first));
    return {h * inverse_denominator, product(first, inverse_denominator)};
  }

  /// |D(h)|² of one lane.
  double squared_denominator(int lane, double h) const {
    const double re = 1 + h * (q_[0].re.lane(lane) + h * q_[1].re.lane(lane));
    const double im = h * (q_[0].im.lane(lane) + h * q_[1].im.lane(lane));
    return re * re + im * im;
  }

 private:
  using Denominator = std::array<Number, 2>;

  /// Two vectors whose angle is less than that are one direction: relative to their length.
  static constexpr double parallel = 1e-6;

  /// Σ conj(a)·b
  static void add_inner_product(const Number& a, const Number& b, SplitSum<Real>& sum) {
    sum.add_product({a.re, -a.im}, b);
  }

  /// q with |x_k + q_1 x_{k−1} + q_2 x_{k−2}| smallest, by its normal equations.
  static Denominator denominator(const std::vector<Number>& series, int order, int k) {
    SplitSum<Real> first_first, second_first, second_second, first_right, second_right;
    for (std::size_t i = static_cast<std::size_t>(k); i < series.size(); i += order + 1) {
      const Number &right = series[i], &first = series[i - 1], &second = series[i - 2];
      add_inner_product(first, first, first_first);
      add_inner_product(second, first, second_first);
      add_inner_product(second, second, second_second);
      add_inner_product(first, right, first_right);
      add_inner_product(second, right, second_right);
    }
    const Real length = first_first.value().re, other_length = second_second.value().re;
    const Real inverse_length = reciprocal(length, Real{});
    const Number slope = inverse_length * second_first.value();  // conj of x_{k−2}'s part along x_{k−1}
    const Real rest = fused_minus(length, fused(slope.re, slope.re, slope.im * slope.im), other_length);
    const Real inverse_rest = reciprocal(rest, constant(parallel * parallel, Real{}) * other_length);
    const Number right = first_right.value();
    const Number q_second = -inverse_rest * fused_minus(slope, right, second_right.value());
    const Number along = fused(Number{slope.re, -slope.im}, q_second, inverse_length * right);
    return only_finite({-along, q_second});
  }

  /// 1/length where it is a number above `least`, else 0.
  static Real reciprocal(Real length, Real least) {
    const Real inverse_length = constant(1, Real{}) / length;
    Real result;
    for (int lane = 0; lane < Real::count; ++lane) {
      const bool counts = length.lane(lane) > least.lane(lane) && std::isfinite(inverse_length.lane(lane));
      result.set_lane(lane, counts ? inverse_length.lane(lane) : 0);
    }
    return result;
  }

  static Denominator only_finite(Denominator q) {
    for (int lane = 0; lane < Real::count; ++lane) {
      const double sum = size_of(q[0]).lane(lane) + size_of(q[1]).lane(lane);
      if (std::isfinite(sum)) continue;
      for (Number& coefficient : q) set(coefficient, lane, 0);
    }
    return q;
  }

  /// The largest component of x_N + q_1 x_{N−1} + q_2 x_{N−2}.
  static Real distance(const std::vector<Number>& series, int order, const Denominator& q) {
    Real largest;
    for (std::size_t i = static_cast<std::size_t>(order); i < series.size(); i += order + 1) {
      const Number sum = fused(q[1], series[i - 2], fused(q[0], series[i - 1], series[i]));
      largest = larger(largest, size_of(sum));
    }
    return largest;
  }

  Denominator q_{};
  Real misfit_{};
};

}  // namespace gcs::GCS_LANES
