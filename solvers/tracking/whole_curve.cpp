#include "solvers/tracking/whole_curve.hpp"

#include "solvers/tracking/general_path.hpp"

namespace gcs {
namespace {

/// Both halves ended; where one of them could not be followed on, that is the end of the whole.
TrackedPath from_end_to_end(const TrackedPath& first, const TrackedPath& second) {
  TrackedPath path = joined(first, second);
  if (first.end == TrackedPath::End::failed && second.end != TrackedPath::End::stopped) {
    path.end = first.end;
    path.cause = first.cause;
  }
  return path;
}

}  // namespace

TrackedPath whole_curve(const FollowCurve& follow, SeriesTrackerOptions options) {
  options.infinite_coordinate = infinite_coordinate;
  const TrackedPath first = follow(options);
  if (first.end == TrackedPath::End::closed || first.end == TrackedPath::End::stopped) return first;
  options.orientation = -options.orientation;
  return from_end_to_end(first, follow(options));
}

}  // namespace gcs
