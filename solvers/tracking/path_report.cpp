#include "solvers/tracking/path_report.hpp"

#include "solvers/model/distance_system.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/model/wide_reference.hpp"

namespace gcs {
namespace {

/// A crossing found by a tracker is good to about 1e-6 of the scene; further away Newton may have gone
/// elsewhere.
constexpr double largest_refinement = 1e-3;

/// The rounding of coordinates leaves 4e-13 of a thousandth of the scene's size, which is the least that
/// relative_residual is relative to.
constexpr double largest_residual = 1e-11;

PathRecord::End record_end(TrackedPath::End end) {
  switch (end) {
    case TrackedPath::End::closed:
      return PathRecord::End::closed;
    case TrackedPath::End::stopped:
      return PathRecord::End::stopped;
    case TrackedPath::End::failed:
      break;
  }
  return PathRecord::End::failed;
}

SolveStatus report_status(TrackedPath::End end) {
  switch (end) {
    case TrackedPath::End::closed:
      return SolveStatus::complete;
    case TrackedPath::End::stopped:
      return SolveStatus::stopped;
    case TrackedPath::End::failed:
      break;
  }
  return SolveStatus::gave_up;
}

}  // namespace

std::optional<std::string> why_no_path(const Scene& scene) {
  if (scene.has_lines()) return "the path S is defined for points only, and the scene has lines";
  if (!scene.sketch()) return "a path strategy starts from a sketch, and the instance has none";
  return std::nullopt;
}

SolveReport path_report(const Scene& scene, TrackedPath path,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of) {
  const DistanceSystem system(scene, wide_reference(scene));
  const std::vector<DoubleDouble> squares = target_squares(scene);
  SolveReport report;
  report.claim = Claim::on_path;
  report.status = report_status(path.end);
  report.reason = path.cause;
  report.work = path.work;
  PathRecord record{record_end(path.end), path.cause, path.length, {}};
  record.proven = path.proven;
  for (const PathCrossing& crossing : path.crossings) {
    Eigen::VectorXd x = system.coordinates(scene.in_frame(figure_of(crossing.point), system.reference()));
    const Eigen::VectorXd before = x;
    const Refinement refinement = refine(system, squares, x);
    report.work.newton_iterations += refinement.iterations;
    const Figure figure = system.figure(x);
    if (!refinement.converged || (x - before).norm() > largest_refinement * scene.size() ||
        relative_residual(scene, figure) > largest_residual) {
      report.status = report.status == SolveStatus::complete ? SolveStatus::partial : report.status;
      report.reason = "a crossing of t = 1 did not refine to a solution";
    }
    record.crossings.push_back({static_cast<int>(report.candidates.size()), crossing.direction});
    report.candidates.push_back({figure, 1});
  }
  report.paths.push_back(std::move(record));
  return report;
}

SolveReport report_once_refined(SeriesTrackerOptions options,
                                const std::function<SolveReport(const SeriesTrackerOptions&)>& track) {
  SolveReport first = track(options);
  if (first.status != SolveStatus::partial) return first;
  options.tolerance *= 1e-3;
  SolveReport second = track(options);
  add(first.work, second.work);
  if (second.status == SolveStatus::complete) return second;
  first.work = second.work;
  return first;
}

}  // namespace gcs
