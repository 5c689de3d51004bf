#pragma once
/// From the solutions of a restated scene (model/released_scene.hpp) to those of the scene as it was given.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/released_scene.hpp"

namespace gcs {

/// The report on `given` that a report on `released`, its restatement, amounts to: the solutions that can be
/// carried back, with lines polished in the given frame (tangents/scene_spheres.hpp), and as many at generic
/// lengths as have the given points where they are. Its paths are those of the restated scene.
SolveReport carried_back(const ReleasedScene& released, const Scene& given, SolveReport report);

}  // namespace gcs
