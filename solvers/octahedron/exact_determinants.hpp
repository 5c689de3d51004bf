#pragma once
/// Cayley–Menger determinants of an octahedron's elements, exactly, with diagonals as unknowns: does it move?

#include <utility>
#include <vector>

#include "solvers/numeric/rational_polynomial.hpp"
#include "solvers/octahedron/octahedron.hpp"
#include "solvers/octahedron/pair_entries.hpp"

namespace gcs {

/// Entries of an octahedron's pairs, in the scene's unit: numbers, and polynomials for aa' and bb'.
class SymbolicEntries {
 public:
  /// The diagonals are by default the unknowns 0 and 1. Keeps a reference to the octahedron.
  SymbolicEntries(const Scene& scene, const Octahedron& octahedron,
                  std::vector<RationalPolynomial> diagonals = {RationalPolynomial::variable(0),
                                                               RationalPolynomial::variable(1)})
      : exact_(scene), octahedron_(octahedron), diagonals_(std::move(diagonals)) {}

  /// Precondition: p and q are not the last pair.
  RationalPolynomial operator()(int p, int q) const;
  bool is_plane(int element) const { return exact_.is_plane(element); }

 private:
  ExactEntries exact_;
  const Octahedron& octahedron_;
  std::vector<RationalPolynomial> diagonals_;
};

/// Of twice the products of the elements seen from `apex`: the Cayley–Menger determinant up to a positive factor and a
/// sign, so that it is > 0 where that many elements of R³ are in general position. It does not depend on which of them
/// is the apex; one of them is a point.
RationalPolynomial gram_determinant(const SymbolicEntries& entries, int apex, std::vector<int> others);

/// True when a curve of solutions is proven: for two of the diagonals, aa' and bb', the two determinants have
/// a common factor that the one of {a, a', b, b'} does not have, so that almost everywhere on the curve those
/// four are in general position and carry c and c'. False: not so, or not proven.
bool is_proven_to_flex(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
