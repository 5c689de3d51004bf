#pragma once
/// What full-space and rcp ask of the trackers.

#include "solvers/model/scene.hpp"
#include "solvers/tracking/euler_newton_tracker.hpp"
#include "solvers/tracking/path_settings.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

struct PathOptions {
  SeriesTrackerOptions fast;
  EulerNewtonOptions paper;
};

/// Steps and orders of the fast mode, and steps of the paper's.
std::vector<OptionMap> path_accuracy_settings();

/// `paper_step_max`: what [I] states for δmax, which step_max=auto stands for.
PathOptions path_options(const PathSettings& settings, double paper_step_max);

/// The same, with the times beyond which S is given up in this scene. Precondition: it has a sketch.
PathOptions for_scene(PathOptions path, const Scene& scene);

}  // namespace gcs
