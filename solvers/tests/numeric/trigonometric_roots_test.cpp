#include "solvers/numeric/trigonometric_roots.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/tests/random_numbers.hpp"

using gcs::real_zeros;
using gcs::TwoHarmonics;
using gcs::samples::RandomNumbers;

namespace {

constexpr double pi = std::numbers::pi;

double value(const TwoHarmonics& f, double phi) {
  return f.constant + f.cos1 * std::cos(phi) + f.sin1 * std::sin(phi) + f.cos2 * std::cos(2 * phi) +
         f.sin2 * std::sin(2 * phi);
}

double bisect(const TwoHarmonics& f, double low, double high) {
  const bool low_negative = value(f, low) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((value(f, middle) < 0) == low_negative ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Dense sampling with bisection: slow, and blind only to pairs of zeros between two samples.
std::vector<double> zeros_by_sampling(const TwoHarmonics& f) {
  constexpr int samples = 20000;
  std::vector<double> zeros;
  for (int i = 0; i < samples; ++i) {
    const double low = -pi + 2 * pi * (i + 0.3) / samples;
    const double high = low + 2 * pi / samples;
    if ((value(f, low) < 0) != (value(f, high) < 0)) zeros.push_back(bisect(f, low, high));
  }
  for (double& zero : zeros) zero = zero > pi ? zero - 2 * pi : zero;
  std::sort(zeros.begin(), zeros.end());
  return zeros;
}

/// 2·(1 − cos(φ − a))·(c − cos(φ − b)): a double zero at a, and two simple ones where |c| < 1.
TwoHarmonics with_double_zero(double a, double b, double c) {
  TwoHarmonics f;
  f.constant = 2 * c + std::cos(a - b);
  f.cos1 = -2 * c * std::cos(a) - 2 * std::cos(b);
  f.sin1 = -2 * c * std::sin(a) - 2 * std::sin(b);
  f.cos2 = std::cos(a + b);
  f.sin2 = std::sin(a + b);
  return f;
}

}  // namespace

TEST_CASE("the zeros of a trigonometric polynomial are those that sampling finds") {
  RandomNumbers random(1);
  std::array<int, 5> with{};
  for (int i = 0; i < 400; ++i) {
    TwoHarmonics f;
    for (double* c : {&f.constant, &f.cos1, &f.sin1, &f.cos2, &f.sin2}) *c = random.uniform(-1, 1);
    const std::vector<double> zeros = real_zeros(f), expected = zeros_by_sampling(f);
    REQUIRE(zeros.size() == expected.size());
    ++with[zeros.size()];
    for (std::size_t k = 0; k < zeros.size(); ++k) CHECK(std::abs(zeros[k] - expected[k]) <= 1e-11);
  }
  CHECK((with[0] > 0 && with[2] > 0 && with[4] > 0));
}

TEST_CASE("zeros at the ends of the ranges of the half angle are found once") {
  CHECK(real_zeros({0, 0, 1, 0, 0}) == std::vector<double>{0, pi});
  const std::vector<double> quarter{-pi / 2, pi / 2};
  const std::vector<double> found = real_zeros({0, 1, 0, 0, 0});
  REQUIRE(found.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(found[i] == Approx(quarter[i]).epsilon(1e-15));
  CHECK(real_zeros({0, 0, 0, 0, 1}).size() == 4);
}

TEST_CASE("a zero at pi/2 or -pi/2 is found whichever sign the sum of the coefficients has by rounding") {
  // cos1 and sin2 take part in no value at ±π/2, where constant ± sin1 − cos2 is 0 to rounding.
  const double tenth = 0.1;
  std::vector<TwoHarmonics> samples{{-0.51, 1.13, 1.28, 0.77, 0.48}};
  RandomNumbers random(3);
  for (int i = 0; i < 2000; ++i) {
    const double constant = std::round(random.uniform(-99, 99)) * tenth;
    const double cos2 = std::round(random.uniform(-99, 99)) * tenth;
    samples.push_back({constant, random.uniform(-9, 9), cos2 - constant, cos2, random.uniform(-9, 9)});
  }
  for (const TwoHarmonics& f : samples)
    for (const double side : {1.0, -1.0}) {
      const double slope = -side * f.cos1 - 2 * f.sin2;
      if (std::abs(slope) < 1e-3) continue;
      const std::vector<double> zeros = real_zeros({f.constant, f.cos1, side * f.sin1, f.cos2, f.sin2});
      INFO(f.constant << " " << f.cos1 << " " << side * f.sin1 << " " << f.cos2 << " " << f.sin2);
      CHECK(std::count_if(zeros.begin(), zeros.end(),
                          [&](double zero) { return std::abs(zero - side * pi / 2) <= 1e-10; }) == 1);
    }
}

TEST_CASE("a double zero is found as one, as two neighbours, or not at all, and disturbs no other") {
  RandomNumbers random(2);
  for (int i = 0; i < 200; ++i) {
    const double a = random.uniform(-3, 3), b = random.uniform(-3, 3), c = random.uniform(-0.9, 0.9);
    const auto is_simple = [&](double zero) { return std::abs(std::cos(zero - b) - c) < 1e-6; };
    const auto is_double = [&](double zero) { return std::abs(std::sin((zero - a) / 2)) < 1e-6; };
    if (std::abs(std::cos(a - b) - c) < 1e-2) continue;  // three zeros together
    const std::vector<double> zeros = real_zeros(with_double_zero(a, b, c));
    CHECK(std::count_if(zeros.begin(), zeros.end(), is_simple) == 2);
    CHECK(std::count_if(zeros.begin(), zeros.end(), is_double) <= 2);
    CHECK(std::all_of(zeros.begin(), zeros.end(), [&](double z) { return is_simple(z) || is_double(z); }));
  }
}

TEST_CASE("what vanishes nowhere or everywhere has no zeros") {
  CHECK(real_zeros({}).empty());
  CHECK(real_zeros({3, 1, 0.5, -0.5, 0.25}).empty());
  CHECK(real_zeros({-3, 1, 0.5, -0.5, 0.25}).empty());
}
