#pragma once
/// Solutions at infinity that points in space have at all lengths. The m-Bézout bound counts them, too.
///
/// Let points H be held, and each other one i be (x : s : w) on the smooth quadric x·x = s w of P⁴, with the place x/w, at
/// infinity where w = 0. A given distance r is s w' − 2 x·x' + w s' = r² w w', a section of a line bundle that its sections
/// generate, and the bundles meet in N points, the m-Bézout bound: general sections have N zeros, m of them next to an isolated
/// zero of multiplicity m of any. So isolated zeros, wherever they are, have a multiplicity of N at most together.
///
/// Theorem. For a set S of points that are not held let T be their neighbours outside S, held ones too, and F all points that
/// are neither held nor in S. Let S be (v : s : 0), with one v ≠ 0, v·v = 0, and one s; then the distances in S hold, and those
/// from S to T say that T lies in the plane 2 v·x = s. Let the plane be placed by two points of T, and points of F by three
/// distances from placed ones, or by two and the plane, each by exactly so much, so that every distance outside S and every
/// point of T in the plane is used once. At generic lengths each has two places, or at least one where the normals' vector
/// product, or the difference of the two points, has the square 0. If, in local coordinates, all equations but the k distances
/// in S have independent derivatives, and the forms
///   (dx − dx')·(dx − dx') − (ds − ds')(dw − dw') − r² dw dw'
/// of these k have no common zero but 0 where the other equations' derivatives vanish, each such zero has the multiplicity 2ᵏ.
///
/// Proof. Less x·x − s w and x'·x' − s' w' the distance in S is that form, with x₃ = 1: by the others' implicit functions k
/// equations in k unknowns are left whose leading forms have degree 2 and meet in 0 alone. Positions of held points and of F with
/// T in the plane, and v and s, are an irreducible variety, of as many dimensions as positions of held points and lengths
/// outside S. A tangent along which these stay has one dv, one ds and dw = 0 in S, so that the forms vanish, and it is 0: over
/// generic positions and lengths there are finitely many places, and what is not 0 at one place is not 0 at any of them. All
/// roots of each step are in the variety, and differ where there are two, as lengths are free.
///
/// Zeros of different S differ, as S is where w = 0. Isolated solutions at any lengths and held positions have as many next to them
/// at generic ones, with multiplicities: there are no more than N less the zeros above, over all S. Whether determinants are 0
/// is computed modulo a prime of Z[√−1], at random places: what is not 0 there is not 0; where it seems to be nothing follows.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/numeric/natural.hpp"

namespace gcs {

struct InfiniteSolutions {
  std::vector<int> points;  ///< S
  Natural count;  ///< of zeros, with multiplicities, twice for each point that hangs on three others
};

/// Those of points 0 to points − 1 in space that are found, while `held` are held. None of more than 64 points; sets of points
/// are tried until `sets_left` is 0, and k is 5 at most. The same for each call. Precondition: well posed with these held.
std::vector<InfiniteSolutions> infinite_solutions(std::size_t points,
                                                  const std::vector<std::array<int, 2>>& edges,
                                                  const std::vector<int>& held, std::int64_t& sets_left);

}  // namespace gcs
