#pragma once
/// What a file's own numbers say of an octahedron: is a pair of diagonals at infinity?
///
/// A closed walk b c b' c' along four edges can be stretched flat when its lengths with some signs sum to
/// zero; then, and only then, a solution with infinite |aa'| has b, c, b' and c' on a line like that: at
/// X = |aa'|² = ∞ the Cayley–Menger determinants of {a, a', b, b', c} and {a, a', b, b', c'} leave
/// |bb'| = ±|bc| ± |cb'| and |bb'| = ±|bc'| ± |c'b'|. They have no common zero at X = |bb'|² = ∞.

#include <array>

#include "solvers/numeric/rational.hpp"
#include "solvers/octahedron/octahedron.hpp"

namespace gcs {

/// Σ ±√a_i of four numbers. Square roots of numbers no two of which have a square as their quotient are
/// linearly independent over the rational numbers (Besicovitch 1940), so that it is decided exactly.
class RootSum {
 public:
  /// Precondition: all are > 0.
  explicit RootSum(const std::array<Rational, 4>& squares);
  bool vanishes(const std::array<int, 4>& signs) const;

 private:
  /// √a_i is factor_[i] times the root of the first number of its class.
  std::array<std::size_t, 4> class_;
  std::array<Rational, 4> factor_;
};

/// How many solutions are at infinity: one at least for each walk and each choice of signs, all different.
int stretched_walks(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
