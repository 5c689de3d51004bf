#include "solvers/numeric/integer_polynomial.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace gcs;

namespace {

const RationalPolynomial x = RationalPolynomial::variable(0), y = RationalPolynomial::variable(1);

int real_ones(const IntegerPolynomial& polynomial) {
  const std::vector<PolynomialRoot> roots = polynomial.roots();
  return static_cast<int>(
      std::count_if(roots.begin(), roots.end(), [](const PolynomialRoot& root) { return root.is_real; }));
}

}  // namespace

TEST_CASE("real roots are counted once each, and roots have their multiplicities") {
  const RationalPolynomial three = x - Rational(3);
  const IntegerPolynomial polynomial(
      (x * x - Rational(2)) * three * three * (x * x + Rational(1)) * (Rational(1) / Rational(7)), 0);
  CHECK(polynomial.degree() == 6);
  CHECK_FALSE(polynomial.is_squarefree());
  CHECK(polynomial.real_root_count() == 3);
  CHECK(real_ones(polynomial) == 3);
  CHECK(polynomial.value(Rational(3)).is_zero());
  int sum = 0;
  for (const PolynomialRoot& root : polynomial.roots()) {
    sum += root.multiplicity;
    CHECK((root.multiplicity == 2) == (std::abs(root.value - 3.0) < 1e-12));
  }
  CHECK(sum == 6);
}

TEST_CASE("two real roots and two conjugate ones are told apart however near they are") {
  const RationalPolynomial small = Rational::from_decimal("1e-60"), one = Rational(1);
  CHECK(IntegerPolynomial((x - one) * (x - one - small), 0).real_root_count() == 2);
  const IntegerPolynomial conjugate((x - one) * (x - one) + small * small, 0);
  CHECK(conjugate.is_squarefree());
  CHECK(conjugate.real_root_count() == 0);
  CHECK(real_ones(conjugate) == 0);
}

TEST_CASE("a resultant vanishes exactly where there is a common zero, one at infinity included") {
  const RationalPolynomial circle = x * x + y * y - Rational(25), line = x + y - Rational(7);
  const IntegerPolynomial eliminated(resultant(circle, line, 1), 0);  // (3, 4) and (4, 3)
  CHECK(eliminated.degree() == 2);
  CHECK(eliminated.value(Rational(3)).is_zero());
  CHECK(eliminated.value(Rational(4)).is_zero());
  // x·y = 1 and x·y = 2 meet at y = ∞ over x = 0 alone.
  const IntegerPolynomial at_infinity(resultant(x * y - Rational(1), x * y - Rational(2), 1), 0);
  CHECK(at_infinity.degree() == 1);
  CHECK(at_infinity.value(Rational(0)).is_zero());
  CHECK(resultant(circle * line, line, 1).is_zero());
}

TEST_CASE("terms of a polynomial add up to it") {
  const RationalPolynomial polynomial = (x + y) * (x - y) - y * Rational(3);
  CHECK(polynomial.terms().size() == 3);
  CHECK(polynomial.total_degree() == 2);
  CHECK(polynomial.value({Rational(5), Rational(2)}) == Rational(15));
  RationalPolynomial sum = Rational(0);
  for (const RationalPolynomial::Term& term : polynomial.terms()) {
    RationalPolynomial product = term.coefficient;
    for (int i = 0; i < RationalPolynomial::variables; ++i)
      for (int k = 0; k < term.exponents[static_cast<std::size_t>(i)]; ++k)
        product = product * RationalPolynomial::variable(i);
    sum = sum + product;
  }
  CHECK((sum - polynomial).is_zero());
}
