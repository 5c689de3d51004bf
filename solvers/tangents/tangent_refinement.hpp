#pragma once
/// Newton's method on the six equations of a common tangent: u·u = 1, p·u = 0 and the distances of the four
/// centres, (|w|² − (w·u)² − r²)/2 = 0 with w = c − p (Hoffmann, Yuan 2000, equations (1)–(6)).

#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

struct TangentRefinement {
  /// Newton's method converged, the Jacobian is regular and the line is near the first one.
  bool is_regular = false;
  int iterations = 0;
};

/// Improves the line in place; where the result is not regular the line is left as it came. Residuals are in
/// double-double, so that what is left is the rounding of the coordinates. Precondition: lengths of order 1.
template <class Scalar>
TangentRefinement refine(const FourSpheres& spheres, Tangent<Scalar>& line);

/// Newton's method in the directions that a multiple solution determines well, by singular values: the others
/// are left as they came. Improves the line in place.
template <class Scalar>
void settle(const FourSpheres& spheres, Tangent<Scalar>& line);

/// Two lines m ± s v next to the line m, their mean: v is the direction that the equations f determine least
/// at m, w the combination of f that varies least there, and w·(f(m) + s²/2 f''(v, v)) = 0. Conjugate where m
/// is real and s² negative.
std::array<Tangent<std::complex<double>>, 2> split(const FourSpheres& spheres,
                                                   const Tangent<std::complex<double>>& mean);

/// The largest |d² − r²| over the four spheres, with u·u = 1 assumed and evaluated in double-double.
template <class Scalar>
double largest_excess(const FourSpheres& spheres, const Tangent<Scalar>& line);

}  // namespace gcs
