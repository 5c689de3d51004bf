#pragma once
/// S of any scene, followed by Taylor series.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

/// From the sketch until it closes or, in a general scene, from one of its ends to the other. Precondition: the scene has a
/// sketch, and either points alone, nothing but distances between them, or as many equations as unknowns.
SolveReport follow_scene_path(const Scene& scene, SeriesTrackerOptions options,
                              const TrackerContext& context);

}  // namespace gcs
