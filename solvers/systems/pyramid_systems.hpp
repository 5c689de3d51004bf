#pragma once
/// The systems of Hoffmann, Yuan 2000 for five points and a line, 5p1L: the line is the x-axis, the apex p5 is
/// (0, 0, r5). Names as there: r_i the distance of p_i from the line, d_i from p5, d_ij of two points.
///
/// quadrics, their (7): twelve equations in (x_i, y_i, z_i), i = 1 … 4,
///   y_i² + z_i² = r_i²,  x_i² + y_i² + (z_i − r5)² = d_i²,  |p_i − p_j|² = d_ij² for ij = 12, 23, 34, 41.
///
/// parametrised, their (8) and (9): p1 by the parameter t = z1, and z2, z4 eliminated. With
/// k_ij = (d_i² + d_j² − d_ij²)/2 the distance of p1 and p2 says (p1 − p5)·(p2 − p5) = k12, that is
///   z2 − r5 = (k12 − x1 x2 − y1 y2)/(t − r5).
/// Put into the other equations, and multiplied by powers of t − r5, that is ten equations in x1, y1, t, x2, y2, x4, y4,
/// x3, y3, z3:
///   (8)  x1² = d1² − r1² − r5² + 2 r5 t,  y1² = r1² − t²
///   D1   4 (t − r5)² y2² + (2 r5 (t − r5) + 2 k12 − 2 x1 x2 − 2 y1 y2)² = 4 r2² (t − r5)²
///   D2   (t − r5)(x2² + r2² − r5² − d2²) + 2 r5 (x1 x2 + y1 y2 − k12) = 0
///   D3, D4   the same of p4
///   D5   (t − r5)(x2 x3 + y2 y3 − k23) + (k12 − x1 x2 − y1 y2)(z3 − r5) = 0
///   D6   (t − r5)(x3 x4 + y3 y4 − k34) + (k14 − x1 x4 − y1 y4)(z3 − r5) = 0
///   y3² + z3² = r3²,  x3² + y3² + (z3 − r5)² = d3².
/// The printed (9) are the six equations D1 to D6, in eight unknowns when (8) is put in as roots: the last two, which
/// make them as many, are not printed. Where t = r5 all of D1 to D6 hold with x1 x2 + y1 y2 = k12 and
/// x1 x4 + y1 y4 = k14: a set of zeros of dimension 3 that are none of the problem's (is_extraneous).

#include "solvers/model/scene.hpp"
#include "solvers/pyramid/pyramid.hpp"
#include "solvers/systems/written_system.hpp"

namespace gcs {

/// Exact where r5, or its square root where the file gives a square, is rational.
SystemOrReason pyramid_quadrics(const Scene& scene, const Pyramid& pyramid);
SystemOrReason pyramid_parametrised(const Scene& scene, const Pyramid& pyramid);

}  // namespace gcs
