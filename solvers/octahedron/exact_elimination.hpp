#pragma once
/// An octahedron as one polynomial in one unknown, exactly: the geometric way of Hoffmann, Vermeer 1995 (as Hoffmann,
/// Yuan 2000, section 4.2, tell of it), which by resultants comes to a univariate polynomial of degree 16.
///
/// Points and names as in diagonal_equations.hpp. The resultant P(X) in Y of the Cayley–Menger determinants of
/// {a, a', b, b', c} and {a, a', b, b', c'} has degree 8: Bézout's number on P¹ × P¹, less one for each pair of
/// diagonals with X at infinity. With w(X), the Gram determinant of b − a, c − a, a' − a, the resultant Q(v) in X
/// of P(X) and v² − w(X) has twice that degree; v is six times the volume of the tetrahedron abca', with a sign, which is
/// to say the height of a' over the plane abc. (Of which unknown theirs is, the paper does not say. Half angles, as in
/// its section 4.1, have no rational coefficients: there is no rational point on the circle of a' as a rule.)
///
/// Theorem. Let abc be a triangle with corners in general position, and Q have no multiple root. Then Q has as many real
/// roots as there are real octahedra of these lengths in the fixed frame, mirror images apart.
///
/// Proof. Roots of P that belong to v ≠ −v are simple too, and 0 is no root of Q. Each root X belongs to one common zero
/// (X, Y) of the determinants, a simple one, so that a, a', b, b' are not coplanar (else the gradients of both
/// determinants are made of the coefficients of their one affine dependence, and parallel) and it is the zero of one octahedron up to motions of C³ and mirror images, or
/// Y is at infinity. If X is real, so is Y, as the conjugate zero has the same X, and so are all squared distances. The
/// Gram matrix of b − a, c − a, a' − a is then real, has a positive definite minor and the determinant w: it is positive
/// definite, and the octahedron is real, for v² = w > 0, v real; it is indefinite, and there is no real octahedron, for
/// v imaginary. If Y is at infinity a, c, a' are on a line, so that w = −(a square) < 0 or 0. If X is not real, v is
/// not, or Q has a double root, which the conjugate X gives too. ∎
///
/// With planes among a', b', c' (pair_entries.hpp) X is an entry and w the Gram determinant of b − a, c − a and a' − a or
/// the normal of a'. The proof stays as it is with elements whose vectors of R^{4,1} are dependent together with e in place
/// of coplanar points, and with a singular Gram matrix of c − a and a' − a or that normal in place of a line.
///
/// Octahedra with symmetries have solutions that share X. With U = X + λY in place of X the resultant R(U, λ) =
/// c(λ) Π (U − x_i − λ y_i) tells them apart, and gives X back: at a simple root y_i = −R_λ/R_U. So the theorem holds for
/// P(U) = R(U, λ), any λ, and v the volume times R_U. Where a, a', b, b' are coplanar in a solution, as with a centre of
/// symmetry, neither says anything.

#include <optional>

#include "solvers/numeric/integer_polynomial.hpp"
#include "solvers/octahedron/octahedron.hpp"

namespace gcs {

struct OctahedronPolynomials {
  /// P, in X = |aa'|² in the scene's unit; 0 where the determinants have a common factor.
  IntegerPolynomial diagonal;
  IntegerPolynomial height;     ///< Q; 0 where P is
  bool has_round_base = false;  ///< the triangle abc is not flat: proven

  /// In the fixed frame, mirror images apart; nothing where the theorem says nothing.
  std::optional<int> real_solutions() const;
};

/// The same number by X + λY for some λ; nothing where a solution is multiple.
std::optional<int> separated_real_solutions(const Scene& scene, const Octahedron& octahedron);

/// P alone.
IntegerPolynomial diagonal_polynomial(const Scene& scene, const Octahedron& octahedron);

OctahedronPolynomials eliminated(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
