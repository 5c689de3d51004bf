#pragma once
/// A curve that is followed from a point of it to both sides.

#include <functional>

#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

/// To one side, until the curve is closed or ends.
using FollowCurve = std::function<TrackedPath(const SeriesTrackerOptions&)>;

/// All of it: as the first half where that is closed or was stopped, otherwise both halves in one, from the end of the
/// second on; its end is that of a half that failed, if one did. A half ends at infinity where a coordinate is beyond
/// infinite_coordinate.
TrackedPath whole_curve(const FollowCurve& follow, SeriesTrackerOptions options);

}  // namespace gcs
