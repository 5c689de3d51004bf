#pragma once
/// The bound for points in space that form a ring of six rigid bodies, each hinged to the next.
///
/// Theorem. Let n points in space and 3n − 6 given distances of them be such that
///   (i)   bodies B_0 … B_5 are each built from a triangle, point by point, by distances from three before,
///   (ii)  B_i and B_{i+1} (indices modulo 6) share two points and no more, the hinge, at a given distance,
///   (iii) every given distance is within one body, or is a hinge and within the two that it joins,
///   (iv)  every point is in one body more than it is on hinges.
/// Then no lengths leave more than 2^(n − 2) isolated solutions in the fixed frame, counted with
/// multiplicity.
///
/// Proof, over C, with d·d for the square of a vector d. At generic lengths body i has 2^(|B_i| − 3) shapes
/// in the frame of its triangle, no hinge has d·d = 0, and by (iii) and (iv) a solution is a shape of each
/// body and a closed chain of rotations about the hinges. By (iv) Σ|B_i| = n + 12, the six hinges having
/// twelve ends: there are 2^(n − 6) choices of shapes. For each the chain closes in at most 16 ways:
/// - A rotation about the line through a in the direction d is the dual quaternion x + y(d + ε a×d) with
///   (x : y) ∈ P¹. The product of three takes (P¹)³ to Study's quadric Q ⊂ P⁷, which holds the motions: f(u)
///   those that carry B_0 to B_3 by way of B_1 and B_2, g(v) by way of B_5 and B_4, times a constant
///   motion. Solutions have f(u) = g(v).
/// - On the 6-dimensional quadric Q the classes of codimension 3 are spanned by those of its two families of
///   3-planes, α and β, with α² = β² = 0 and αβ = 1; three hyperplanes cut out h³ = α + β. Let α be the class
///   of the plane where primal parts vanish, and call the primal part of f q₁q₂q₃, in 2×2 matrices. For
///   hinges in general position f is a Segre embedding up to a projective map, hence of degree 6; q₁q₂q₃ = 0
///   only if q₁ and q₃ are singular, for two values of u₁ and two of u₃, and q₂, linear in u₂, maps the image
///   of q₃ into the kernel of q₁, for one u₂. So [f]·α = 4 and [f]·β = 2: [f] = 2α + 4β. Likewise [g], and
///   [f]·[g] = 2·4 + 4·2 = 16.
/// - Moved by a general element γ of SO(8), which acts transitively on Q, γ·g(v) meets f(u) in exactly 16
///   points (Kleiman). f(u) = g(v) is locally six equations in six unknowns, and so an isolated solution of
///   multiplicity m, for any hinges, turns into m solutions when the hinges and γ = 1 are moved a little into
///   general position: there are at most 16.
/// The distance equations too are as many as unknowns: isolated solutions at any lengths are no more than at
/// generic ones.
///
/// For 16 see also M. Raghavan, B. Roth: Inverse kinematics of the general 6R manipulator and related
/// linkages. J. Mech. Design 115 (1993), whose manipulator closes to such a chain.

#include <array>
#include <optional>
#include <vector>

#include "solvers/numeric/natural.hpp"

namespace gcs {

struct RingBound {
  Natural fixed_frame;
  std::vector<std::vector<int>> bodies;  ///< six, around the ring: their points in order
};

/// The theorem's bound for points 0 … points − 1, or nothing when no bodies grown as far as they go form such
/// a ring. `triangles`: all triples with their distances among the edges. Precondition: in space, well posed.
std::optional<RingBound> ring_bound(int points, const std::vector<std::array<int, 2>>& edges,
                                    const std::vector<std::vector<int>>& triangles);

}  // namespace gcs
