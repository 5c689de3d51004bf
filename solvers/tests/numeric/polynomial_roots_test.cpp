#include "solvers/numeric/polynomial_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solvers/tests/random_numbers.hpp"

using gcs::real_roots;
using gcs::samples::RandomNumbers;

namespace {

using Coefficients = std::vector<double>;
using LongCoefficients = std::vector<long double>;

LongCoefficients product(const LongCoefficients& a, const LongCoefficients& b) {
  LongCoefficients c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// scale · Π (s − root)
LongCoefficients with_roots(const std::vector<double>& roots, long double scale = 1) {
  LongCoefficients c{scale};
  for (const double root : roots) c = product(c, {-root, 1});
  return c;
}

Coefficients rounded(const LongCoefficients& c) {
  Coefficients result;
  result.reserve(c.size());
  for (const long double value : c) result.push_back(static_cast<double>(value));
  return result;
}

/// How far rounding of the coefficients and of Horner's rule can move a simple root.
double uncertainty(const LongCoefficients& c, double root) {
  long double size = 0;
  long double slope = 0;
  for (std::size_t i = c.size(); i-- > 0;) {
    size = size * std::abs(root) + std::abs(c[i]);
    if (i > 0) slope = slope * root + static_cast<long double>(i) * c[i];
  }
  const auto terms = static_cast<long double>(2 * c.size());
  return static_cast<double>(terms * std::numeric_limits<double>::epsilon() * size / std::abs(slope));
}

/// The simple roots given, and no others, are found.
void check_found(const LongCoefficients& c, std::vector<double> roots, double end) {
  std::sort(roots.begin(), roots.end());
  const std::vector<double> found = real_roots(rounded(c), end);
  REQUIRE(found.size() == roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i)
    CHECK(std::abs(found[i] - roots[i]) <= uncertainty(c, roots[i]) + 1e-15 * end);
}

/// Roots in (0, end), at least `gap` apart.
std::vector<double> separated_roots(RandomNumbers& random, int count, double end, double gap) {
  std::vector<double> roots;
  while (static_cast<int>(roots.size()) < count) {
    const double root = random.uniform(gap, end - gap);
    if (std::all_of(roots.begin(), roots.end(), [&](double r) { return std::abs(r - root) > gap; }))
      roots.push_back(root);
  }
  return roots;
}

}  // namespace

TEST_CASE("a polynomial without roots in the interval has none") {
  CHECK(real_roots(Coefficients{3}, 1).empty());
  CHECK(real_roots(Coefficients{-3, 1}, 1).empty());
  CHECK(real_roots(Coefficients{1, 0, 1}, 10).empty());
  CHECK(real_roots(Coefficients{1, 1, 1, 1}, 1).empty());
  // Passes as low as 1e-6 above zero at s = 1/2.
  CHECK(real_roots(Coefficients{0.25 + 1e-6, -1, 1}, 1).empty());
  // The roots −1 and 2 are outside.
  CHECK(real_roots(Coefficients{-2, -1, 1}, 1).empty());
}

TEST_CASE("a root at 0 does not count and one at the end does") {
  CHECK(real_roots(Coefficients{0, 1}, 1).empty());
  CHECK(real_roots(Coefficients{0, 0, 1, 1}, 1).empty());
  CHECK(real_roots(Coefficients{-1, 1}, 1) == std::vector<double>{1});
  CHECK(real_roots(Coefficients{-0.5, 1}, 0.5) == std::vector<double>{0.5});
  CHECK(real_roots(Coefficients{0, -0.5, 1}, 0.5) == std::vector<double>{0.5});
  const std::vector<double> both = real_roots(Coefficients{0, 0.125, -0.75, 1}, 0.5);
  REQUIRE(both.size() == 2);
  CHECK(both[0] == Approx(0.25).margin(1e-12));
  CHECK(both[1] == 0.5);
}

TEST_CASE("a root at the end counts once, whatever lies before it") {
  const std::vector<double> both = real_roots(Coefficients{0.125, -0.75, 1}, 0.5);
  REQUIRE(both.size() == 2);
  CHECK(both[0] == Approx(0.25).margin(1e-15));
  CHECK(both[1] == 0.5);
  // (s − 1/4)(s − 3/4)(s − 1)
  CHECK(real_roots(Coefficients{-0.1875, 1.1875, -2, 1}, 1).size() == 3);
}

TEST_CASE("roots where the search halves its interval are found once, and their neighbours too") {
  RandomNumbers random(3);
  for (int sample = 0; sample < 300; ++sample) {
    CAPTURE(sample);
    std::vector<double> roots = separated_roots(random, 3, 1, 0.05);
    const double halving = (1 + random.index(15)) / 16.0;
    if (std::any_of(roots.begin(), roots.end(), [&](double r) { return std::abs(r - halving) < 0.02; }))
      continue;
    roots.push_back(halving);
    check_found(with_roots(roots), roots, 1);
  }
}

TEST_CASE("whatever is reported near a double root lies within the reach of rounding") {
  for (int k = 1; k < 32; ++k) {
    const double root = k / 32.0;
    const std::vector<double> found = real_roots(Coefficients{root * root, -2 * root, 1}, 1);
    for (const double value : found) CHECK(value == Approx(root).margin(2e-8));
  }
}

TEST_CASE("a simple root is found beside a triple one") {
  // Rounding splits the triple root by up to its cube root.
  const std::vector<double> found = real_roots(rounded(with_roots({0.25, 0.25, 0.25, 0.75})), 1);
  REQUIRE(found.size() >= 2);
  CHECK(found.size() % 2 == 0);
  CHECK(found.back() == Approx(0.75).margin(1e-13));
  for (std::size_t i = 0; i + 1 < found.size(); ++i) CHECK(found[i] == Approx(0.25).margin(1e-4));
}

TEST_CASE("clustered roots are told apart down to their conditioning") {
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    CAPTURE(gap);
    const std::vector<double> pair{0.4, 0.4 + gap};
    check_found(with_roots(pair), pair, 1);
  }
  const std::vector<double> cluster{0.5, 0.501, 0.502, 0.9};
  check_found(with_roots(cluster), cluster, 1);
}

TEST_CASE("random products of linear factors give back their roots") {
  RandomNumbers random(1);
  for (int sample = 0; sample < 400; ++sample) {
    CAPTURE(sample);
    const double end = std::ldexp(random.uniform(1, 2), random.index(21) - 10);
    const std::vector<double> inside = separated_roots(random, 1 + random.index(5), end, end / 40);
    std::vector<double> all = inside;
    for (int i = random.index(4); i > 0; --i)
      all.push_back(random.sign() > 0 ? -random.uniform(0.1, 2) * end : random.uniform(1.1, 3) * end);
    check_found(with_roots(all, random.sign() * random.uniform(0.01, 100)), inside, end);
  }
}

TEST_CASE("polynomials of high degree with distant complex roots give back their near ones") {
  RandomNumbers random(2);
  for (int sample = 0; sample < 200; ++sample) {
    CAPTURE(sample);
    const std::vector<double> inside = separated_roots(random, random.index(5), 1, 0.05);
    LongCoefficients c = with_roots(inside);
    // Factors 1 − 2·cos(φ)·s/ρ + s²/ρ² of complex pairs.
    while (c.size() + 2 <= 33) {
      const double radius = random.uniform(10, 30);
      c = product(c, {1, random.uniform(-2, 2) / radius, 1 / (radius * radius)});
    }
    check_found(c, inside, 1);
  }
}

TEST_CASE("sparse polynomials of degree 32 give back their roots") {
  for (const double root : {0.25, 0.5, 0.9, 0.999}) {
    Coefficients c(33, 0);
    c[32] = 1;
    c[0] = -std::pow(root, 32);
    const std::vector<double> found = real_roots(c, 1);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == Approx(root).epsilon(1e-14));
  }
  // (s^16 − a)(s^16 − b)
  const double a = std::pow(0.7, 16);
  const double b = std::pow(0.8, 16);
  Coefficients c(33, 0);
  c[0] = a * b;
  c[16] = -a - b;
  c[32] = 1;
  const std::vector<double> found = real_roots(c, 1);
  REQUIRE(found.size() == 2);
  CHECK(found[0] == Approx(0.7).epsilon(1e-13));
  CHECK(found[1] == Approx(0.8).epsilon(1e-13));
}

TEST_CASE("scaling the polynomial or the interval by powers of two changes nothing else") {
  const Coefficients c = rounded(with_roots({0.1, 0.35, 0.8, -0.4}));
  const std::vector<double> roots = real_roots(c, 1);
  REQUIRE(roots.size() == 3);
  for (const int exponent : {-200, -20, 20, 200}) {
    Coefficients scaled = c;
    for (double& value : scaled) value = std::ldexp(value, exponent);
    CHECK(real_roots(scaled, 1) == roots);

    Coefficients stretched = c;
    for (std::size_t i = 0; i < c.size(); ++i)
      stretched[i] = std::ldexp(c[i], -exponent * static_cast<int>(i));
    const std::vector<double> found = real_roots(stretched, std::ldexp(1.0, exponent));
    REQUIRE(found.size() == roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) CHECK(found[i] == std::ldexp(roots[i], exponent));
  }
}
