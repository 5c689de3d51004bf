#pragma once
/// Where S of a general scene begins.

#include <Eigen/Core>
#include <optional>

#include "solvers/elements/scene_system.hpp"

namespace gcs {

/// The sketch, moved to where it meets the equations that have no value.
struct SketchedUnknowns {
  Eigen::VectorXd x;
  double moved = 0;  ///< by how much the unknown that changed most did
};

/// Bodies are where a rigid motion is nearest to their sketched points; from there Gauss-Newton steps of least length
/// lead on. Nothing where they do not settle. Precondition: the scene has a sketch.
std::optional<SketchedUnknowns> sketched_unknowns(const Scene& scene, const SceneSystem& system);

}  // namespace gcs
