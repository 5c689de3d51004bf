#pragma once
/// The parameters of a path in lanes, with their Taylor series.

#include <array>
#include <vector>

#include "solvers/lanes/complex_lanes.hpp"
#include "solvers/lanes/lane_tracker.hpp"

namespace gcs::GCS_LANES {

template <class Real>
class LaneRoute {
 public:
  using Number = Complex<Real>;

  explicit LaneRoute(std::size_t parameters) : moves_(parameters), rates_(parameters), end_(parameters) {
    for (auto& coefficient : coefficients_) coefficient.resize(parameters);
  }

  std::size_t parameters() const { return end_.size(); }
  /// Whether any route so far had rates.
  bool has_rates() const { return has_rates_; }
  /// How many parameters were others along any route so far.
  std::size_t moving() const { return moving_; }
  /// Whether parameter j was another one along any route so far.
  bool moves(std::size_t j) const { return moves_[j] != 0; }

  void load(int lane, const Route& route) {
    for (std::size_t j = 0; j < end_.size(); ++j) {
      for (int k = 0; k <= Route::degree; ++k) set(coefficients_[k][j], lane, route.coefficients[k][j]);
      set(end_[j], lane, route.end[j]);
      rates_[j].set_lane(lane, route.rates.empty() ? 0 : route.rates[j]);
      bool moves = route.end[j] != route.coefficients[0][j] || (!route.rates.empty() && route.rates[j] != 0);
      for (int k = 1; k <= Route::degree; ++k) moves = moves || route.coefficients[k][j] != 0.0;
      moving_ += moves && !moves_[j] ? 1 : 0;
      moves_[j] = moves_[j] || moves;
    }
    has_rates_ = has_rates_ || !route.rates.empty();
  }

  /// Parameter j at s; where `arriving` is not 0, at the end.
  Number value(std::size_t j, Real s, Real arriving) const {
    if (!moves(j)) return coefficients_[0][j];
    const Number sum = term(j, 0, s);
    return selected(arriving, end_[j], has_rates_ ? growth(j, s) * sum : sum);
  }

  /// The k-th Taylor coefficient of parameter j at s. Precondition: it has no rate.
  Number term(std::size_t j, int k, Real s) const {
    if (k > Route::degree) return {};
    Number sum{};
    for (int i = Route::degree; i >= k; --i)
      sum = fused(s, sum, constant(binomials[i][k], Real{}) * coefficients_[i][j]);
    return sum;
  }

  /// The Taylor coefficients of parameter j at s up to this order; of one that rests only the first.
  void series(std::size_t j, Real s, int order, Number* terms) const {
    if (!moves(j)) {
      terms[0] = coefficients_[0][j];
      return;
    }
    for (int k = 0; k <= order; ++k) terms[k] = term(j, k, s);
    if (!has_rates_) return;
    // A parameter that has a rate is otherwise constant: the product's series has but one summand.
    const Real factor = growth(j, s);
    Real power = factor;
    for (int k = 0; k <= order; ++k) {
      terms[k] = k == 0 ? power * terms[0] : power * coefficients_[0][j] + factor * terms[k];
      power = power * rates_[j] * constant(1.0 / (k + 1), Real{});
    }
  }

 private:
  static constexpr double binomials[Route::degree + 1][Route::degree + 1] = {
      {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};

  /// e^(rate·(s − 1)) of every lane.
  Real growth(std::size_t j, Real s) const {
    Real result = constant(1, Real{});
    for (int lane = 0; lane < Real::count; ++lane)
      if (rates_[j].lane(lane) != 0)
        result.set_lane(lane, std::exp(rates_[j].lane(lane) * (s.lane(lane) - 1)));
    return result;
  }

  bool has_rates_ = false;
  std::vector<char> moves_;
  std::size_t moving_ = 0;
  std::array<std::vector<Number>, Route::degree + 1> coefficients_;
  std::vector<Real> rates_;
  std::vector<Number> end_;
};

}  // namespace gcs::GCS_LANES
