#pragma once
/// The bound for points in a wheel beside a line: a hub, n ≥ 3 others at given distances from it, each also from the next
/// around, and all n + 1 from the line.
///
/// Theorem. No lengths above 0 leave more than 2·4ⁿ − 4·((1 + √3)ⁿ + (1 − √3)ⁿ) isolated solutions in the fixed frame, four
/// of each class: 12, 72, 360, 1632, … classes for n = 3, 4, 5, 6.
///
/// Proof, at generic lengths; isolated solutions at others are no more. Let the line be the x-axis and the hub (0, 0, h).
/// - A point (x, dc, ds) with c² + s² = 1 at the distance a from the hub has x² = α + 2dh s, α = a² − d² − h²: a smooth
///   quartic curve C in P³, with coordinates (w : x : c : s). With e = c + is, ē = c − is, so eē = w², it is at infinity,
///   w = 0, in I (e = 0) and Ī (ē = 0) alone. The given distance of two neighbours is F = 0, F linear in the coordinates of
///   either. So on C₁ × … × Cₙ there are n divisors without base points, each of degree 4 in two neighbours: 2·4ⁿ isolated
///   zeros at most, with multiplicities, one end of each distance being chosen in one of two ways around.
/// - Near I let ē = 1: e = w², s = i(1 − w²)/2, x² = αw² + Bw(1 − w²), B = idh. So y = x/B is a coordinate of C, w = By² + …, and
///   for two neighbours near I, whose distance is r, F/(BB') = (y − y')² − r²y⁴ + … on y' = y + y²v, v finite: F is the product of
///   two smooth factors, y' = y ± ry² + ….
/// - Where y' is near I and its neighbour is not, F = B' − dd'e − 2xB'y' + …: it vanishes at e = ih/d, where x² = a². Beside these
///   two points Q it is smooth, d(e − ih/d) = −2ihx y' + …, to first order alike for both neighbours of Q.
/// - Zeros at infinity: neighbours of points at I are at I or Q, for at Ī F is not 0, and no Q is one for Ī, where e = id/h. Two
///   neighbours in Q have the distance ±a ± a', and more points in a row that are finite between points at infinity have one
///   distance too many: not at generic lengths. So there are a set S of points, no two of them neighbours, in one of two Q each,
///   and the others in I, or likewise with Ī. The n − 2|S| distances between points at I have two factors each; whichever are
///   chosen, once around y becomes y + κy² + …: the multiplicity is 2, as κ ≠ 0, or more. (κ has ±r for each of these distances,
///   and the square of every other one.)
/// - Together that is 2·2·Σ 2^|S| 2^(n − 2|S|) = 4·trace((2, 1), (2, 0))ⁿ, the eigenvalues being 1 ± √3.
///
/// For n = 3, a tetrahedron, these are the common tangents of four spheres (Macdonald, Pach, Theobald 2001).

#include <optional>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/numeric/natural.hpp"

namespace gcs {

/// The theorem's bound in the fixed frame; nothing where these are no points in a wheel beside a line, or in one of more than
/// 30 spokes. `references` are not looked at. Precondition: lengths are above 0.
std::optional<Natural> wheel_bound(const BoundProblem& problem);

}  // namespace gcs
