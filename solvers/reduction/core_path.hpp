#pragma once
/// Solutions of a whole scene from those on the path of its core.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// `report`: on the first of `parts`, with figures of all points of the scene (in its unit), of which those
/// of the core are placed. Hung points are placed one after another, each on the side of its base on which it
/// is in the sketch; a solution at which one has no real place is left out with its crossings, and named in
/// the reason. The plans of the path go, as they are of the core alone. Precondition: the scene has a sketch.
SolveReport with_hung_points(const Scene& scene, const std::vector<Part>& parts, SolveReport report);

}  // namespace gcs
