#pragma once
/// Cayley–Menger determinants of an octahedron's points, exactly, with squared diagonals as unknowns: does it move?

#include <utility>
#include <vector>

#include "solvers/numeric/rational_polynomial.hpp"
#include "solvers/octahedron/exact_squares.hpp"

namespace gcs {

/// Squared distances of an octahedron's points, in the scene's unit: numbers, and polynomials for |aa'|² and |bb'|².
class SymbolicSquares {
 public:
  /// The diagonals are by default the unknowns 0 and 1. Keeps a reference to the octahedron.
  SymbolicSquares(const Scene& scene, const Octahedron& octahedron,
                  std::vector<RationalPolynomial> diagonals = {RationalPolynomial::variable(0),
                                                               RationalPolynomial::variable(1)})
      : exact_(scene), octahedron_(octahedron), diagonals_(std::move(diagonals)) {}

  /// Precondition: p and q are not the last pair.
  RationalPolynomial operator()(int p, int q) const;

 private:
  ExactSquares exact_;
  const Octahedron& octahedron_;
  std::vector<RationalPolynomial> diagonals_;
};

/// Of twice the products of the vectors from `apex` to `points`: the Cayley–Menger determinant up to a
/// positive factor and a sign, so that it is > 0 where that many points of R³ are in general position.
RationalPolynomial gram_determinant(const SymbolicSquares& squares, int apex, const std::vector<int>& points);

/// True when a curve of solutions is proven: for two of the diagonals, aa' and bb', the two determinants have
/// a common factor that the one of {a, a', b, b'} does not have, so that almost everywhere on the curve those
/// four are no flat tetrahedron and carry c and c'. False: not so, or not proven.
bool is_proven_to_flex(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
