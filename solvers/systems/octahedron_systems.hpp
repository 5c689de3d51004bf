#pragma once
/// The systems of Hoffmann, Yuan 2000, section 4.1, for the octahedral problem 6p.
///
/// The triangle abc is placed: a at the origin, b on the x-axis, c in the xy-plane. What is left are nine distances, of
/// a', b', c' from the triangle and from each other.

#include "solvers/model/scene.hpp"
#include "solvers/octahedron/octahedron.hpp"
#include "solvers/systems/written_system.hpp"

namespace gcs {

/// The nine quadrics in the coordinates (X, Y, z) of a', b', c' in turn, X = |ab|·x and Y = y_c·y, in which all
/// coefficients are rational: |p|² = X²/|ab|² + Y²/y_c² + z². Exact.
SystemOrReason octahedron_quadrics(const Scene& scene, const Octahedron& octahedron);

/// The Cayley–Menger determinants of {a, a', b, b', c} and {a, a', b, b', c'} in |aa'|² and |bb'|², after Michelucci.
/// Exact.
PolynomialSystem octahedron_determinants(const Scene& scene, const Octahedron& octahedron);

/// Each of a', b', c' turns about an edge of abc, by an angle whose half has the tangent t: what is left of the quadrics
/// when the linear ones among their combinations are solved and the circles parametrised. Three equations, of a'b',
/// b'c' and c'a', of degree 2 in either t and of degree 4 together:
///   (K + A + B + G) + (K − A + B − G) t² + (K + A − B − G) s² + (K − A − B + G) t²s² + 4 F t s = 0,
/// where the points at the angles α, β have the squared distance K + A cos α + B cos β + G cos α cos β + F sin α sin β
/// plus the given one. Coefficients are rounded to doubles: the radii of the circles are square roots. A flat position
/// with the angle π is at infinity.
SystemOrReason octahedron_quartics(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
