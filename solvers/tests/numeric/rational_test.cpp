#include "solvers/numeric/rational.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "solvers/numeric/rational_polynomial.hpp"

using gcs::Rational;
using gcs::RationalPolynomial;

TEST_CASE("decimals are exact rational numbers") {
  CHECK(Rational::from_decimal("1.25e-3") == Rational(1) / Rational(800));
  CHECK(Rational::from_decimal("-12E+2") == Rational(-1200));
  CHECK(Rational::from_decimal("0.1") + Rational::from_decimal("0.2") == Rational::from_decimal("0.3"));
  CHECK_FALSE(Rational::from_double(0.1) == Rational::from_decimal("0.1"));
  CHECK(Rational::from_double(-0.375) == Rational(-3) / Rational(8));
  for (const char* text : {"", "x", "1e", "1e2x", "1.2.3"})
    CHECK_THROWS_AS(Rational::from_decimal(text), std::invalid_argument);
}

TEST_CASE("zero is zero whatever its exponent") {
  for (const char* text : {"0e999999999", "-0.00e-2147483648", "0E+99999999999"})
    CHECK(Rational::from_decimal(text).sign() == 0);
}

TEST_CASE("a rational number far from 1 is rounded as its double") {
  CHECK(Rational::from_decimal("1e-300").approximate() == 1e-300);
  CHECK((Rational::from_decimal("1e-300") * Rational::from_decimal("1e300")).approximate() == 1.0);
  CHECK(Rational::from_decimal("1e-600").approximate_root() == 1e-300);
  CHECK(Rational(2).approximate_root() == std::sqrt(2.0));
  CHECK(Rational(3).times_power_of_two(-1000).approximate() == std::ldexp(3.0, -1000));
}

TEST_CASE("the sign of a difference is decided however small it is") {
  const Rational difference = Rational::from_decimal("0.3000000000000000000000000000000001") -
                              Rational::from_decimal("0.1") - Rational::from_decimal("0.2");
  CHECK(difference.sign() == 1);
  CHECK((Rational::from_decimal("0.1") * Rational(3) - Rational::from_decimal("0.3")).sign() == 0);
}

TEST_CASE("square roots are found where they are rational") {
  CHECK((Rational(49) / Rational(64)).root() == Rational(7) / Rational(8));
  CHECK(Rational(0).root() == Rational(0));
  CHECK_FALSE(Rational(2).root());
  CHECK_FALSE((Rational(4) / Rational(3)).root());
  CHECK_FALSE(Rational(-4).root());
}

TEST_CASE("polynomials have the common divisors that they were given") {
  const RationalPolynomial x = RationalPolynomial::variable(0), y = RationalPolynomial::variable(1);
  const RationalPolynomial common = x * y - Rational(2), left = x + y, right = x - y;
  CHECK(common_divisor(left, right).is_constant());
  const RationalPolynomial divisor = common_divisor(common * left, common * right);
  CHECK_FALSE(divisor.is_constant());
  CHECK(divisor.divided_by(common).is_constant());
}
