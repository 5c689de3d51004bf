#pragma once
/// Scenes with orientations for strategies that know none. Orientations leave the equations as they are: the scene without
/// has the same solutions, one for each class up to reflection, whose mirror images solve the equations too. Which of them are
/// as stated is judged where all answers are assessed.

#include <optional>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Nothing where the scene has no orientations, no frame that its elements can be compared in, or given positions, which
/// mirror images do not keep.
std::optional<Scene> unoriented(const Scene& scene);

/// A report of `unoriented` as one of `scene`, whose classes are up to motion. Neither is anchored.
SolveReport with_mirror_images(SolveReport report, const Scene& unoriented, const Scene& scene);

}  // namespace gcs
