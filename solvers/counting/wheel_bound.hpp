#pragma once
/// The bound for points in a wheel beside a line: a hub, n ≥ 3 others at given distances from it, each also from the next
/// around, and all n + 1 from the line.
///
/// Theorem. No lengths above 0 leave more than 2·4ⁿ − 4·((1 + √3)ⁿ + (1 − √3)ⁿ) isolated solutions in the fixed frame, or
/// than a fourth of that classes: 12, 72, 360, 1632, … for n = 3, 4, 5, 6.
///
/// Proof. Isolated solutions have others next to them at lengths nearby, as equations are as many as unknowns, and those that
/// no reflection of the frame carries into each other have others that none does: so generic lengths have most. Let the line
/// be the x-axis and the hub (0, 0, h).
/// - A point (x, dc, ds) with c² + s² = 1 at the distance a from the hub has x² = α + 2dh s, α = a² − d² − h²: a quartic curve
///   C in P³, smooth as a² ≠ (d ± h)², with coordinates (w : x : c : s). With e = c + is, ē = c − is, so eē = w², it is at
///   infinity, w = 0, in I (e = 0) and Ī (ē = 0) alone. The given distance of two neighbours is F = 0, F linear in the
///   coordinates of either. So on C₁ × … × Cₙ there are n sections of line bundles that their sections generate, each of
///   degree 4 in two neighbours: isolated zeros have a multiplicity of 2·4ⁿ together at most, whatever else there is (Fulton,
///   Intersection Theory, 12.2), as one end of each distance is chosen in one of two ways around.
/// - Near I let ē = 1: e = w², s = i(1 − w²)/2, x² = αw² + Bw(1 − w²), B = idh. So y = x/B is a coordinate of C, w = By² + …,
///   and for two neighbours near I, whose distance is r, F/(BB') = (y − y')² − r²y⁴ + … on y' = y + y²v, v finite: F is the
///   product of two different smooth factors, y' = y ± ry² + ….
/// - Where y' is near I and its neighbour is not, F/B' = 1 − de/(ih) − 2xy' + (a² + a'² + d² − h² − r²)y'² + …: it vanishes
///   at e = ih/d, where x² = a². Beside these two points Q, where e is a coordinate of C, it is smooth, and for both
///   neighbours, y' and y'', of a Q together y'' = y' + (a''² − a'² + r'² − r''²)/(2x) y'² + ….
/// - Zeros at infinity: neighbours of points at I are at I or Q, for at Ī F is not 0. Let m finite points in a row be between
///   points at infinity, perhaps one and the same: of one the ends are of a kind, as Q for Ī has e = id/h and h ≠ d. Of two the
///   distance is what is left, r² = (±a ± a')² or that less (h² − d²)(h² − d'²)/h², and of more the ends are known and m − 1
///   distances depend on m − 2 unknowns: not at generic lengths. So there are a set S of points, no two of them neighbours, in
///   one of two Q each, and the others in I, or likewise with Ī. The n − 2|S| distances between points at I have two factors
///   each. For each choice once around y becomes y + κy² + …, κ the sum of the above, where every r occurs, and not 0: so the
///   zero is isolated, and the choices have a multiplicity of 2 each, which add up.
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
