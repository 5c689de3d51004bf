#pragma once
/// Puts the elements of a scene into a system.

#include "solvers/elements/system_builder.hpp"

namespace gcs {

/// Bodies, points, planes and lines, each with its unknowns. A line that is perpendicular to a plane has its direction,
/// and parallel lines have one; for planes see shared_normals.
void place_elements(SystemBuilder& builder);

}  // namespace gcs
