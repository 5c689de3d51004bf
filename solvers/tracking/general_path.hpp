#pragma once
/// S of a general scene from end to end, and Newton's method in its place.

#include <functional>
#include <memory>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/element_curve.hpp"
#include "solvers/tracking/general_curve.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

/// Whether S is that of the equations of elements, in a frame for these (see in_frame_of_elements). Otherwise it is one of
/// distances between points alone.
inline bool is_path_of_elements(const Scene& scene) {
  return scene.problem().is_general() || scene.has_lines();
}

/// Tracks S from the sketch until it closes. Where it has an end at infinity instead, the other half is tracked too, and
/// the path in the report leads from one end to the other. Precondition: the scene has a sketch, and its equations are as
/// many as its unknowns.
SolveReport follow_general_path(const Scene& scene, const SeriesTrackerOptions& options,
                                const TrackerContext& context);
/// The same by another tracker, which follows S from these unknowns to one side: until it closes or ends.
using FollowHalf = std::function<TrackedPath(const SceneSystem& system, const Eigen::VectorXd& sketched,
                                             const SeriesTrackerOptions& options)>;
SolveReport follow_general_path(const Scene& scene, const SeriesTrackerOptions& options,
                                const FollowHalf& follow_half);
/// The same in the driving parameters of the plan, where full-space does in all coordinates.
SolveReport follow_general_plan(const Scene& scene, const ElementPlan& plan,
                                const SeriesTrackerOptions& options, const ElementCurveOptions& of_curve,
                                const TrackerContext& context);

/// The equations of a general scene at its values, in the unknowns of the system, which outlives them.
std::unique_ptr<TargetEquations> target_values(const SceneSystem& system);

/// In units of the scene: a curve with a coordinate beyond it goes to infinity. Steps grow with the coordinates, so that
/// it takes some hundred to get there.
inline constexpr double infinite_coordinate = 1e6;

/// Both halves of a curve that is not closed, from one end to the other. Each begins at the same point; `second` to the
/// other side.
TrackedPath joined(const TrackedPath& first, const TrackedPath& second);

/// Why S has no start.
inline constexpr const char* too_far_from_incidences =
    "Gauss-Newton steps from the sketch do not settle at a figure that meets the constraints without a value";

/// The values that do not become negative on S.
std::vector<LengthPath> bounding_lengths(const std::vector<TravellingValue>& values);

/// Newton's method at the given values, undamped, from the sketch: no path, and a claim of some real solutions.
SolveReport newton_from_general_sketch(const Scene& scene);

}  // namespace gcs
