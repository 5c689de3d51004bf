#include "solvers/octahedron/exact_elimination.hpp"

#include "solvers/octahedron/exact_determinants.hpp"

namespace gcs {
namespace {

/// Which unknown is which.
constexpr int x = 0, y = 1, v = 2, lambda = 3;

RationalPolynomial variable(int number) { return RationalPolynomial::variable(number); }

RationalPolynomial power(const RationalPolynomial& base, int exponent) {
  RationalPolynomial product = Rational(1);
  for (int k = 0; k < exponent; ++k) product = product * base;
  return product;
}

/// Of a polynomial in X or U, and λ.
RationalPolynomial derivative(const RationalPolynomial& polynomial, int by) {
  RationalPolynomial sum = Rational(0);
  for (const RationalPolynomial::Term& term : polynomial.terms()) {
    const int other = by == x ? lambda : x;
    const int exponent = term.exponents[static_cast<std::size_t>(by)];
    if (exponent > 0)
      sum = sum + power(variable(by), exponent - 1) *
                      power(variable(other), term.exponents[static_cast<std::size_t>(other)]) *
                      (term.coefficient * Rational(exponent));
  }
  return sum;
}

RationalPolynomial with_lambda(const RationalPolynomial& polynomial, const Rational& value) {
  RationalPolynomial sum = Rational(0);
  for (const RationalPolynomial::Term& term : polynomial.terms())
    sum =
        sum + power(variable(x), term.exponents[x]) * power(value, term.exponents[lambda]) * term.coefficient;
  return sum;
}

bool has_round_base(const SymbolicEntries& entries, const Octahedron& octahedron) {
  const int a = octahedron.pair[0][0], b = octahedron.pair[1][0], c = octahedron.pair[2][0];
  return gram_determinant(entries, a, {b, c}).value({}).sign() > 0;
}

/// Without Y.
RationalPolynomial diagonal_resultant(const SymbolicEntries& entries, const Octahedron& octahedron) {
  const auto [a, a2] = octahedron.pair[0];
  const auto [b, b2] = octahedron.pair[1];
  const auto [c, c2] = octahedron.pair[2];
  return resultant(gram_determinant(entries, c, {a, a2, b, b2}),
                   gram_determinant(entries, c2, {a, a2, b, b2}), y);
}

/// w(numerator/denominator) times the square of the denominator.
RationalPolynomial squared_volume(const Scene& scene, const Octahedron& octahedron,
                                  const RationalPolynomial& numerator,
                                  const RationalPolynomial& denominator) {
  constexpr int degree = 2;  // of w
  const auto [a, a2] = octahedron.pair[0];
  const SymbolicEntries entries(scene, octahedron);
  RationalPolynomial sum = Rational(0);
  const RationalPolynomial w =
      gram_determinant(entries, a, {octahedron.pair[1][0], octahedron.pair[2][0], a2});
  for (const RationalPolynomial::Term& term : w.terms())  // whose products are doubled
    sum = sum + power(numerator, term.exponents[x]) * power(denominator, degree - term.exponents[x]) *
                    (term.coefficient / Rational(8));
  return sum;
}

}  // namespace

std::optional<int> OctahedronPolynomials::real_solutions() const {
  if (!has_round_base || height.is_zero() || !height.is_squarefree()) return std::nullopt;
  return height.real_root_count();
}

std::optional<int> separated_real_solutions(const Scene& scene, const Octahedron& octahedron) {
  constexpr int most_tried = 3;
  if (!has_round_base(SymbolicEntries(scene, octahedron), octahedron)) return std::nullopt;
  const RationalPolynomial all = diagonal_resultant(
      SymbolicEntries(scene, octahedron, {variable(x) - variable(lambda) * variable(y), variable(y)}),
      octahedron);
  if (all.is_zero()) return std::nullopt;
  for (int factor = 1; factor <= most_tried; ++factor) {
    const Rational at(factor);
    const RationalPolynomial separated = with_lambda(all, at);
    if (!IntegerPolynomial(separated, x).is_squarefree()) continue;
    const RationalPolynomial slope = with_lambda(derivative(all, x), at);
    // X times the slope.
    const RationalPolynomial product = variable(x) * slope + with_lambda(derivative(all, lambda), at) * at;
    const IntegerPolynomial height(
        resultant(separated, variable(v) * variable(v) - squared_volume(scene, octahedron, product, slope),
                  x),
        v);
    if (height.is_squarefree()) return height.real_root_count();
  }
  return std::nullopt;
}

IntegerPolynomial diagonal_polynomial(const Scene& scene, const Octahedron& octahedron) {
  const RationalPolynomial diagonal = diagonal_resultant(SymbolicEntries(scene, octahedron), octahedron);
  return diagonal.is_zero() ? IntegerPolynomial() : IntegerPolynomial(diagonal, x);
}

OctahedronPolynomials eliminated(const Scene& scene, const Octahedron& octahedron) {
  const SymbolicEntries entries(scene, octahedron);
  OctahedronPolynomials result;
  result.has_round_base = has_round_base(entries, octahedron);
  const RationalPolynomial diagonal = diagonal_resultant(entries, octahedron);
  if (diagonal.is_zero()) return result;
  result.diagonal = IntegerPolynomial(diagonal, x);
  const RationalPolynomial square = squared_volume(scene, octahedron, variable(x), Rational(1));
  result.height = IntegerPolynomial(resultant(diagonal, variable(v) * variable(v) - square, x), v);
  return result;
}

}  // namespace gcs
