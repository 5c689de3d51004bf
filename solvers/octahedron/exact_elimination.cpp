#include "solvers/octahedron/exact_elimination.hpp"

#include "solvers/octahedron/exact_determinants.hpp"

namespace gcs {

std::optional<int> OctahedronPolynomials::real_solutions() const {
  if (!has_round_base || height.is_zero() || !height.is_squarefree()) return std::nullopt;
  return height.real_root_count();
}

OctahedronPolynomials eliminated(const Scene& scene, const Octahedron& octahedron) {
  constexpr int x = 0, y = 1, v = 2;
  const SymbolicSquares squares(scene, octahedron);
  const auto [a, a2] = octahedron.pair[0];
  const auto [b, b2] = octahedron.pair[1];
  const auto [c, c2] = octahedron.pair[2];
  OctahedronPolynomials result;
  result.has_round_base = gram_determinant(squares, a, {b, c}).value({}).sign() > 0;
  const RationalPolynomial diagonal = resultant(gram_determinant(squares, c, {a, a2, b, b2}),
                                                gram_determinant(squares, c2, {a, a2, b, b2}), y);
  if (diagonal.is_zero()) return result;
  const RationalPolynomial height = RationalPolynomial::variable(v);
  result.diagonal = IntegerPolynomial(diagonal, x);
  // The determinant has the products doubled.
  const RationalPolynomial square = gram_determinant(squares, a, {b, c, a2}) * (Rational(1) / Rational(8));
  result.height = IntegerPolynomial(resultant(diagonal, height * height - square, x), v);
  return result;
}

}  // namespace gcs
