#include "solvers/tracking/scene_path.hpp"

#include "solvers/model/reframed_scene.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {

SolveReport follow_scene_path(const Scene& scene, SeriesTrackerOptions options,
                              const TrackerContext& context) {
  if (is_path_of_elements(scene)) return follow_general_path(in_frame_of_elements(scene), options, context);
  options.far = times_far_away(scene.length_paths());
  return report_once_refined(options, [&](const SeriesTrackerOptions& refined) {
    DistanceCurve curve(scene, wide_reference(scene), refined.order, refined.tolerance);
    SeriesTracker tracker(curve, refined, context);
    return path_report(scene, tracker.run(), [&](const Eigen::VectorXd& y) { return curve.figure(y); });
  });
}

}  // namespace gcs
