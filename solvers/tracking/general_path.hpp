#pragma once
/// S of a general scene from end to end, and Newton's method in its place.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

/// Tracks S from the sketch until it closes. Where it has an end at infinity instead, the other half is tracked too, and
/// the path in the report leads from one end to the other. Precondition: the scene has a sketch, and its equations are as
/// many as its unknowns.
SolveReport follow_general_path(const Scene& scene, SeriesTrackerOptions options,
                                const TrackerContext& context);

/// Newton's method at the given values, undamped, from the sketch: no path, and a claim of some real solutions.
SolveReport newton_from_general_sketch(const Scene& scene);

}  // namespace gcs
