#include "solvers/numeric/biquadratic_pair.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

using Complex = std::complex<double>;
constexpr double at_infinity = 1e-9;

Complex value(const Biquadratic& p, Complex x, Complex y) {
  Complex sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += p(i, j) * std::pow(x, i) * std::pow(y, j);
  return sum;
}

Biquadratic random_biquadratic(RandomNumbers& numbers) {
  return Biquadratic::NullaryExpr([&](Eigen::Index, Eigen::Index) { return numbers.uniform(-1, 1); });
}

/// Σ a(i, j) x^i y^j · Σ b(i, j) x^i y^j for factors of degree 1 in each variable.
Biquadratic product(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
  Biquadratic result = Biquadratic::Zero();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) result.block<2, 2>(i, j) += a(i, j) * b;
  return result;
}

bool is_infinite(const CommonZero& zero) {
  return zero.x.nearness_to_infinity() < at_infinity || zero.y.nearness_to_infinity() < at_infinity;
}

std::vector<CommonZero> all_zeros(const CommonZeros& zeros) {
  std::vector<CommonZero> all;
  for (const auto& some : zeros.of_eigenvalue) all.insert(all.end(), some.begin(), some.end());
  return all;
}

/// How often (x, y) is among the zeros.
int times_found(const std::vector<CommonZero>& zeros, Complex x, Complex y, double tolerance) {
  return static_cast<int>(std::count_if(zeros.begin(), zeros.end(), [&](const CommonZero& zero) {
    return !is_infinite(zero) && std::abs(zero.x.value() - x) <= tolerance &&
           std::abs(zero.y.value() - y) <= tolerance;
  }));
}

}  // namespace

TEST_CASE("a shifted biquadratic has the values of the other elsewhere") {
  RandomNumbers numbers(3);
  const Biquadratic p = random_biquadratic(numbers);
  const Biquadratic q = shifted(p, 0.25, -1.5);
  for (int i = 0; i < 20; ++i) {
    const double x = numbers.uniform(-2, 2);
    const double y = numbers.uniform(-2, 2);
    CHECK(std::abs(value(q, x, y) - value(p, x + 0.25, y - 1.5)) <= 1e-13);
  }
}

TEST_CASE("random biquadratics have eight common zeros, all of them zeros and all different") {
  RandomNumbers numbers(1);
  for (int i = 0; i < 200; ++i) {
    const Biquadratic p = random_biquadratic(numbers);
    const Biquadratic q = random_biquadratic(numbers);
    const CommonZeros zeros = common_zeros(p, q);
    REQUIRE_FALSE(zeros.common_factor);
    const std::vector<CommonZero> all = all_zeros(zeros);
    REQUIRE(all.size() == 8);
    for (std::size_t a = 0; a < all.size(); ++a) {
      const Complex x = all[a].x.value();
      const Complex y = all[a].y.value();
      const double size = (1 + std::norm(x)) * (1 + std::norm(y));
      CHECK(std::abs(value(p, x, y)) <= 1e-9 * size);
      CHECK(std::abs(value(q, x, y)) <= 1e-9 * size);
      for (std::size_t b = 0; b < a; ++b)
        CHECK(std::abs(x - all[b].x.value()) + std::abs(y - all[b].y.value()) > 1e-9);
    }
  }
}

TEST_CASE("zeros at infinity are told from finite ones") {
  // x² = 1 and y² = 4: four finite zeros, and x = y = ∞ four times.
  Biquadratic p = Biquadratic::Zero();
  Biquadratic q = Biquadratic::Zero();
  p(2, 0) = 1;
  p(0, 0) = -1;
  q(0, 2) = 1;
  q(0, 0) = -4;
  const std::vector<CommonZero> all = all_zeros(common_zeros(p, q));
  for (const double x : {-1.0, 1.0})
    for (const double y : {-2.0, 2.0}) CHECK(times_found(all, x, y, 1e-6) >= 1);
  int near = 0;
  for (const auto& some : common_zeros(p, q).of_eigenvalue)
    near += std::all_of(some.begin(), some.end(), [](const CommonZero& zero) {
      return zero.x.nearness_to_infinity() < 1e-3;  // a fourfold zero: the fourth root of rounding
    });
  CHECK(near == 4);
}

TEST_CASE("two zeros with one x are both found") {
  // (x − 1)(y² − 1) + (x − 2)·… vanish together at x = 1 wherever y² = 1 does.
  Biquadratic p = Biquadratic::Zero();
  p(0, 2) = 1;
  p(0, 0) = -1;  // y² − 1
  Biquadratic q = p;
  q(1, 1) = 0.5;  // y² − 1 + (x − 1)(x + y)/2
  q(2, 0) = 0.5;
  q(1, 0) = -0.5;
  q(0, 1) = -0.5;
  const std::vector<CommonZero> all = all_zeros(common_zeros(p, q));
  CHECK(times_found(all, 1, 1, 1e-6) >= 1);
  CHECK(times_found(all, 1, -1, 1e-6) >= 1);
  CHECK(times_found(all, -1, 1, 1e-6) >= 1);  // x + y = 0
}

TEST_CASE("a common factor is recognised") {
  RandomNumbers numbers(2);
  for (int i = 0; i < 50; ++i) {
    const auto factor = [&] {
      return Eigen::Matrix2d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return numbers.uniform(-1, 1); })
          .eval();
    };
    const Eigen::Matrix2d common = factor();
    CHECK(common_zeros(product(common, factor()), product(common, factor())).common_factor);
    CHECK_FALSE(common_zeros(product(factor(), factor()), product(common, factor())).common_factor);
  }
}
