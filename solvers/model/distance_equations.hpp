#pragma once
/// Squared distances with the exact numbers of a file, in the unknowns of a DistanceSystem: |p_a − p_b|² = a², and
/// y² + z² = a² of a point and the line, which is the x-axis.

#include "solvers/model/distance_system.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// Of one constraint; what is given on both sides is left out.
QuadraticEquation distance_equation(const Scene& scene, const DistanceSystem& system, int constraint);

/// Of all constraints, in their order.
QuadraticSystem distance_equations(const Scene& scene, const DistanceSystem& system);

}  // namespace gcs
