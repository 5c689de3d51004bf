#include "solvers/lanes/series_tail.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

using namespace gcs::portable_lanes;
using Number = std::complex<double>;

namespace {

constexpr int order = 12;

/// The coefficients up to the order, those of one component after the other, in all lanes.
std::vector<Complex<Lanes>> in_lanes(const std::vector<std::vector<Number>>& components) {
  std::vector<Complex<Lanes>> series;
  for (const std::vector<Number>& component : components)
    for (const Number& coefficient : component) series.push_back(number(coefficient, Lanes{}));
  return series;
}

/// (a + b h)/((1 − h/p)(1 − h/r)), whose coefficients follow from multiplying by the denominator.
std::vector<Number> rational_series(Number a, Number b, Number p, Number r) {
  std::vector<Number> x{a, b + a * (1.0 / p + 1.0 / r)};
  while (x.size() <= order) x.push_back((1.0 / p + 1.0 / r) * x[x.size() - 1] - x[x.size() - 2] / (p * r));
  return x;
}

/// a √(1 − h/p) + b √(1 − h/r) by the binomial series.
std::vector<Number> root_series(Number a, Number b, Number p, Number r) {
  std::vector<Number> x;
  double binomial = 1;  // (−1)^k (1/2 over k)
  for (int k = 0; k <= order; ++k) {
    x.push_back(binomial * (a * std::pow(p, -k) + b * std::pow(r, -k)));
    binomial *= (k - 0.5) / (k + 1);
  }
  return x;
}

/// What a component's series sums up to at h.
Number continued(const SeriesTail<Lanes>& tail, const std::vector<Number>& x, double h) {
  const auto [last, last_but_one] = tail.weights(constant(h, Lanes{}));
  const auto value = [](const Complex<Lanes>& z) { return Number(z.re.lane(0), z.im.lane(0)); };
  Number sum = value(last) * x[order] + value(last_but_one) * x[order - 1];
  for (int k = order - 2; k >= 0; --k) sum = h * sum + x[k];
  return sum;
}

Number truncated(const std::vector<Number>& x, double h) {
  Number sum = 0;
  for (int k = order; k >= 0; --k) sum = h * sum + x[k];
  return sum;
}

const Number p{1, 0.3}, r{-0.9, 0.8};  // two singular points at distances of 1.04 and 1.20

}  // namespace

TEST_CASE("a series with two poles is continued to what it is the series of") {
  const std::vector<std::array<Number, 2>> numerators{
      {Number{1, 2}, Number{-1, 0.5}}, {Number{0.3, -1}, Number{2, 1}}, {Number{-2, 0}, Number{0.1, 0.7}}};
  std::vector<std::vector<Number>> components;
  for (const auto& [a, b] : numerators) components.push_back(rational_series(a, b, p, r));
  SeriesTail<Lanes> tail;
  tail.fit(in_lanes(components), order);
  CHECK(tail.misfit().lane(0) <= 1e-12);
  for (const double h : {0.0, 0.3, 0.8, 1.5}) {
    const Number denominator = (1.0 - h / p) * (1.0 - h / r);
    CHECK(tail.squared_denominator(0, h) == Approx(std::norm(denominator)).epsilon(1e-8));
    for (std::size_t i = 0; i < numerators.size(); ++i) {
      const Number exact = (numerators[i][0] + numerators[i][1] * h) / denominator;
      CHECK(std::abs(continued(tail, components[i], h) - exact) <= 1e-8 * std::abs(exact));
    }
  }
}

TEST_CASE("between branch points the misfit tells the error, far below that of the bare series") {
  const std::vector<std::array<Number, 2>> weights{
      {Number{1, 2}, Number{-1, 0.5}}, {Number{0.3, -1}, Number{2, 1}}, {Number{-2, 0}, Number{0.1, 0.7}}};
  std::vector<std::vector<Number>> components;
  for (const auto& [a, b] : weights) components.push_back(root_series(a, b, p, r));
  SeriesTail<Lanes> tail;
  tail.fit(in_lanes(components), order);
  for (const double h : {0.4, 0.5, 0.6}) {
    const double expected =
        tail.misfit().lane(0) * std::pow(h, order) / std::sqrt(tail.squared_denominator(0, h));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const Number exact = weights[i][0] * std::sqrt(1.0 - h / p) + weights[i][1] * std::sqrt(1.0 - h / r);
      const double error = std::abs(continued(tail, components[i], h) - exact);
      CHECK(error <= 2 * expected);
      CHECK(error <= 0.05 * std::abs(truncated(components[i], h) - exact));
    }
  }
}

TEST_CASE("where no denominator fits, the series ends") {
  const std::vector<Number> one(order + 1, 1), zero(order + 1);
  std::vector<Number> polynomial = zero;
  polynomial[1] = 2;
  const double huge = std::numeric_limits<double>::max();
  for (const std::vector<Number>& component :
       {zero, polynomial, std::vector<Number>(order + 1, {huge, huge})}) {
    SeriesTail<Lanes> tail;
    tail.fit(in_lanes({component}), order);
    const auto [last, last_but_one] = tail.weights(constant(0.5, Lanes{}));
    CHECK(last.re.lane(0) == 0.5);
    CHECK(last_but_one.re.lane(0) == 1);
    CHECK(tail.squared_denominator(0, 0.5) == 1);
  }
  // One component tells but one pole: 1/(1 − h).
  SeriesTail<Lanes> tail;
  tail.fit(in_lanes({one}), order);
  CHECK(continued(tail, one, 0.5).real() == Approx(2));
}
