#include "solvers/tracking/path_report.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/certification/proven_error.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/tracking/touching_solutions.hpp"

namespace gcs {
namespace {

/// A crossing found by a tracker is good to about 1e-6 of the scene; further away Newton may have gone
/// elsewhere.
constexpr double largest_refinement = 1e-3;

/// The rounding of coordinates leaves 4e-13 of a thousandth of the scene's size, which is the least that
/// relative_residual is relative to.
constexpr double largest_residual = 1e-11;

constexpr const char* not_told_apart =
    "S comes so near to touching t = 1 that the solutions there are not told apart";

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

/// Coordinates at which S meets t = 1.
struct MetSolution {
  Eigen::VectorXd x;
  int direction = 1;
  double at = 0;
  bool has_neighbour = false;  ///< so near that an estimate of its error does not tell them apart
};

/// The solutions next to an extremum of t, in the order in which S meets them. `before`: where S comes from.
std::vector<MetSolution> in_order(const TouchingSolutions& near, const Eigen::VectorXd& extremum,
                                  const Eigen::VectorXd& before, const PathTouch& touch) {
  std::vector<MetSolution> met;
  for (const Eigen::VectorXd& x : near.x) met.push_back({x, touch.direction, touch.at, true});
  if (met.empty()) return met;
  if (near.direction.dot(extremum - before) < 0) std::swap(met[0], met[1]);
  met[1].direction = -touch.direction;
  return met;
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
  const auto falls_short = [&report](std::string reason) {
    report.status = report.status == SolveStatus::complete ? SolveStatus::partial : report.status;
    report.reason = std::move(reason);
  };
  const auto coordinates_of = [&](const Eigen::VectorXd& point) {
    return system.coordinates(scene.in_frame(figure_of(point), system.reference()));
  };
  std::vector<MetSolution> met;
  for (const PathCrossing& crossing : path.crossings)
    met.push_back({coordinates_of(crossing.point), crossing.direction, crossing.at});
  for (const PathTouch& touch : path.touches) {
    const Eigen::VectorXd extremum = coordinates_of(touch.point);
    const auto near = solutions_at_touch(system, squares, extremum, report.work);
    if (!near) {
      falls_short(not_told_apart);
      continue;
    }
    std::erase_if(met, [&](const MetSolution& one) { return std::abs(one.at - touch.at) <= touch.reach; });
    const std::vector<MetSolution> there = in_order(*near, extremum, coordinates_of(touch.before), touch);
    met.insert(met.end(), there.begin(), there.end());
  }
  std::stable_sort(met.begin(), met.end(),
                   [](const MetSolution& one, const MetSolution& other) { return one.at < other.at; });
  PathRecord record{record_end(path.end), path.cause, path.length, {}};
  record.proven = path.proven;
  for (MetSolution& one : met) {
    const Eigen::VectorXd before = one.x;
    const Refinement refinement = refine(system, squares, one.x);
    report.work.newton_iterations += refinement.iterations;
    const Figure figure = system.figure(one.x);
    if (!refinement.converged || (one.x - before).norm() > largest_refinement * scene.size() ||
        relative_residual(scene, figure) > largest_residual)
      falls_short("a crossing of t = 1 did not refine to a solution");
    record.crossings.push_back({static_cast<int>(report.candidates.size()), one.direction});
    report.candidates.push_back({figure, 1});
    if (one.has_neighbour) {
      const double error = report.candidates.back().error = proven_error(scene, squares, figure);
      if (!std::isfinite(error) && jacobian_condition(scene, figure) >= stiff_condition)
        falls_short(not_told_apart);
    }
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
