#include "solvers/numeric/positive_polynomial.hpp"

#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Coefficients = std::vector<Rational>;

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] = c[i + j] + a[i] * b[j];
  return c;
}

/// (t − root)²
Coefficients touching(double root) {
  const Coefficients factor{Rational(0) - Rational::from_double(root), Rational(1)};
  return product(factor, factor);
}

}  // namespace

TEST_CASE("a polynomial that touches zero is not positive, lifted by little it is") {
  RandomNumbers random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const double root = trial == 0 ? 0.5 : random.uniform(0.05, 0.95);
    Coefficients c = product(touching(root), touching(2 + root));
    const auto found = where_not_positive(c);
    REQUIRE(found);
    CHECK(*found == Approx(root).epsilon(1e-9));
    c[0] = c[0] + Rational(1).times_power_of_two(-60);
    CHECK_FALSE(where_not_positive(c));
    c[0] = c[0] - Rational(1).times_power_of_two(-59);
    CHECK(where_not_positive(c));
  }
}

TEST_CASE("roots outside the interval do not matter, roots at its ends do") {
  const Coefficients before{Rational(1).times_power_of_two(-40), Rational(1)};  // −2^-40
  CHECK_FALSE(where_not_positive(before));
  CHECK(where_not_positive({Rational(0), Rational(1)}) == 0.0);
  CHECK(where_not_positive({Rational(1), Rational(-1)}) == 1.0);
  CHECK_FALSE(where_not_positive({Rational(7)}));
  CHECK(where_not_positive({Rational(-7)}) == 0.0);
  CHECK_FALSE(where_not_positive(product(before, touching(1.25))));
}

TEST_CASE("two near roots are found between neighbours of any grid") {
  RandomNumbers random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const double root = random.uniform(0.1, 0.9);
    const Coefficients first{Rational(0) - Rational::from_double(root), Rational(1)};
    const Coefficients second{Rational(0) - Rational::from_double(root + 1e-8), Rational(1)};
    const auto found = where_not_positive(product(first, second));
    REQUIRE(found);
    CHECK(*found == Approx(root).epsilon(1e-6));
  }
}
