#pragma once
/// Decisions about four spheres that rounding must not take: with the exact decimals of the file.

#include <array>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/rational_vector.hpp"

namespace gcs {

/// In the scene's unit, in the order of spheres_of (scene_spheres.hpp).
struct ExactSphere {
  RationalVector center;
  Rational square;  ///< of the radius
};

using ExactSpheres = std::array<ExactSphere, 4>;

/// Precondition: four points with given positions, each constrained against one line.
ExactSpheres exact_spheres_of(const Scene& scene);

/// Whether the spheres have infinitely many common tangents, complex ones included. With P as in
/// tangent_equations.hpp, that is whether two forms in the direction u have a common factor: where the
/// centres are not coplanar the cubic P·u and the quartic P·P − r²(u·u)²; where they are, the quadratic form
/// that the three distances linear in P leave, and the form of degree 6 of the other two conditions without
/// τ. False where the cubic or the quadratic form is a multiple of u·u: nothing is decided then.
/// Precondition: the centres are not collinear.
bool have_infinitely_many_tangents(const ExactSpheres& spheres);

}  // namespace gcs
