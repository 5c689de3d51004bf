#pragma once
/// A frame that rounding does not turn.

#include "solvers/model/scene.hpp"

namespace gcs {

/// The scene's reference unless one of its given edges is shorter than 1/8 of the scene's size: then points
/// that are pairwise constrained whose shortest edge is as long as can be, the first of them. Coordinates in
/// a frame on an edge of length ε are worse conditioned by 1/ε. Where there is a line, the one that DistanceSystem
/// takes for the scene.
Reference wide_reference(const Scene& scene);

}  // namespace gcs
