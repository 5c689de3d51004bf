#pragma once
/// The systems of Hoffmann, Yuan 2000, section 4.1, for a line at given distances from four points, 4p1L, exactly. For
/// their paths see tangents/published_tangents.hpp, which says what the equations are.

#include <optional>

#include "solvers/systems/polynomial_system.hpp"
#include "solvers/tangents/exact_spheres.hpp"

namespace gcs {

/// Their (1) to (6) in p and u.
PolynomialSystem tangent_quadrics(const ExactSpheres& spheres);

/// In u, of degrees 2, 3 and 4, p eliminated. Nothing where the centres are coplanar.
std::optional<PolynomialSystem> tangent_cubic(const ExactSpheres& spheres);

}  // namespace gcs
