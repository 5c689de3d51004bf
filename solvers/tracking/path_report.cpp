#include "solvers/tracking/path_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/figures/fold_solutions.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_equations.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/numeric/rounding.hpp"
#include "solvers/tracking/flat_refinement.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// A crossing found by a tracker is good to about 1e-6 of the scene; further away Newton may have gone
/// elsewhere.
constexpr double largest_refinement = 1e-3;

/// The rounding of coordinates leaves 4e-13 of a thousandth of the scene's size, which is the least that
/// relative_residual is relative to.
constexpr double largest_residual = 1e-11;

/// Cosine of the angle between the curve and where the solutions next to an extremum lie: others are not on it.
constexpr double on_curve = 0.5;

constexpr const char* not_told_apart =
    "S comes so near to touching t = 1 that the solutions there are not told apart";

PathRecord::End record_end(TrackedPath::End end) {
  switch (end) {
    case TrackedPath::End::closed:
      return PathRecord::End::closed;
    case TrackedPath::End::reached:
      return PathRecord::End::regular;
    case TrackedPath::End::at_infinity:
      return PathRecord::End::at_infinity;
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
    case TrackedPath::End::reached:
    case TrackedPath::End::at_infinity:
      return SolveStatus::complete;
    case TrackedPath::End::stopped:
      return SolveStatus::stopped;
    case TrackedPath::End::failed:
      break;
  }
  return SolveStatus::gave_up;
}

class TargetDistances final : public TargetEquations {
 public:
  TargetDistances(const Scene& scene, std::function<Figure(const Eigen::VectorXd&)> figure_of)
      : scene_(scene), figure_of_(std::move(figure_of)), system_(scene, wide_reference(scene)) {}

  Eigen::VectorXd coordinates(const Eigen::VectorXd& point) const override {
    return system_.coordinates(scene_.in_frame(figure_of_(point), system_.reference()));
  }
  Refinement refine(Eigen::VectorXd& x) const override { return gcs::refine(system_, squares_, x); }
  std::optional<Eigen::VectorXd> refine_where_flat(const Eigen::VectorXd& x, double most) const override {
    return flat_refinement(WideEquations(distance_equations(scene_, system_)), x, most);
  }
  std::optional<FoldSolutions> at_fold(const Eigen::VectorXd& near, WorkCounters& work) const override {
    return solutions_at_fold(system_, squares_, near, work);
  }
  std::optional<FoldSolutions> proven_at_fold(const Eigen::VectorXd& near) const override;
  Figure figure(const Eigen::VectorXd& x) const override { return system_.figure(x); }
  double proven_error(const Figure& figure) const override {
    return gcs::proven_error(scene_, squares_, figure);
  }

 private:
  const Scene& scene_;
  const std::function<Figure(const Eigen::VectorXd&)> figure_of_;
  const DistanceSystem system_;
  const std::vector<DoubleDouble> squares_ = target_squares(scene_);
};

std::optional<FoldSolutions> TargetDistances::proven_at_fold(const Eigen::VectorXd& near) const {
  if (scene_.has_lines()) return std::nullopt;
  constexpr int solutions = 2;
  constexpr double turned =
      16 * unit_roundoff;  // by the rounding of figures in another frame, of their extent
  const ResolvedCandidates found =
      resolve_nearly_singular(scene_, {{scene_.in_frame(figure(near)), solutions}}, {}, solutions, {});
  if (found.list.size() != solutions || !found.are_told_apart) return std::nullopt;
  FoldSolutions result;
  for (const Candidate& solution : found.list) {
    if (!solution.figure.is_real()) continue;
    result.x.push_back(system_.coordinates(scene_.in_frame(solution.figure, system_.reference())));
    result.errors.push_back(solution.error + turned * extent(solution.figure));
  }
  return along_their_line(std::move(result));
}

/// Coordinates at which S meets t = 1.
struct MetSolution {
  Eigen::VectorXd x;
  int direction = 1;
  double at = 0;
  bool has_neighbour = false;  ///< so near that an estimate of its error does not tell them apart
  double error = std::numeric_limits<double>::infinity();  ///< where x is a proven solution's
};

/// Makes the report of one path. A shortcoming leaves a complete report partial; the first one is named.
class PathReporter {
 public:
  PathReporter(const Scene& scene, const TargetEquations& equations) : scene_(scene), equations_(equations) {
    report_.claim = Claim::on_path;
  }

  SolveReport run(const TrackedPath& path) {
    if (path.end == TrackedPath::End::reached) report_.claim = Claim::some_real;
    report_.status = report_status(path.end);
    report_.reason = path.cause;
    report_.work = path.work;
    PathRecord record{record_end(path.end), path.cause, path.length, {}};
    record.proven = path.proven;
    for (const MetSolution& met : met_on(path)) {
      Candidate candidate = candidate_of(met);
      record.crossings.push_back({static_cast<int>(report_.candidates.size()), met.direction});
      report_.candidates.push_back(std::move(candidate));
    }
    report_.paths.push_back(std::move(record));
    return std::move(report_);
  }

 private:
  void falls_short(const char* reason) {
    if (report_.status == SolveStatus::complete) report_.status = SolveStatus::partial;
    if (report_.reason.empty()) report_.reason = reason;
  }

  /// In path order. Next to an extremum of t near 1 the exact lengths decide, not what the tracker took for
  /// crossings.
  std::vector<MetSolution> met_on(const TrackedPath& path) {
    std::vector<MetSolution> met;
    for (const PathCrossing& crossing : path.crossings)
      met.push_back({equations_.coordinates(crossing.point), crossing.direction, crossing.at});
    double end_of_last = 0;
    for (const PathTouch& touch : path.touches) {
      const bool is_alone = touch.at - touch.reach > end_of_last;
      end_of_last = touch.at + touch.reach;
      const auto there = is_alone ? met_at(touch) : std::nullopt;
      if (!there) {
        falls_short(not_told_apart);
        continue;
      }
      std::erase_if(met, [&](const MetSolution& one) { return std::abs(one.at - touch.at) <= touch.reach; });
      met.insert(met.end(), there->begin(), there->end());
    }
    std::ranges::stable_sort(met, {}, &MetSolution::at);
    return met;
  }

  static bool are_apart(const std::vector<Eigen::VectorXd>& x) {
    constexpr double apart = 1e-6;  // relative to the coordinates: their errors are proven in doubles
    return (x[1] - x[0]).norm() > apart * x[0].cwiseAbs().maxCoeff();
  }

  /// By a proof where double-double does not tell two solutions and none, or these two, apart: as long as proofs succeed, and
  /// not for each of many turns of a curve.
  std::optional<FoldSolutions> decided_at_fold(const Eigen::VectorXd& extremum) {
    auto found = equations_.at_fold(extremum, report_.work);
    if ((found && (found->x.empty() || are_apart(found->x))) || proofs_left_ == 0) return found;
    auto proven = equations_.proven_at_fold(extremum);
    proofs_left_ = proven ? proofs_left_ - 1 : 0;
    return proven ? proven : found;
  }

  /// None or two, or nothing where that is not known.
  std::optional<std::vector<MetSolution>> met_at(const PathTouch& touch) {
    const Eigen::VectorXd extremum = equations_.coordinates(touch.point);
    const auto near = decided_at_fold(extremum);
    if (!near) return std::nullopt;
    std::vector<MetSolution> met;
    for (std::size_t i = 0; i < near->x.size(); ++i) {
      met.push_back({near->x[i], touch.direction, touch.at, true});
      if (!near->errors.empty()) met.back().error = near->errors[i];
    }
    if (met.empty()) return met;
    const Eigen::VectorXd way = extremum - equations_.coordinates(touch.before);
    const double along = near->direction.dot(way) / way.norm();
    if (!(std::abs(along) >= on_curve)) return std::nullopt;
    if (along < 0) std::swap(met[0], met[1]);
    met[1].direction = -touch.direction;
    return met;
  }

  /// Refined by Newton's method where it is not proven.
  Candidate candidate_of(const MetSolution& met) {
    if (std::isfinite(met.error)) return {equations_.figure(met.x), 1, met.error};
    const double most = largest_refinement * scene_.size();
    const auto is_solution = [&](const Eigen::VectorXd& x) {
      return (x - met.x).norm() <= most &&
             relative_residual(scene_, equations_.figure(x)) <= largest_residual;
    };
    Eigen::VectorXd x = met.x;
    const Refinement refinement = equations_.refine(x);
    report_.work.newton_iterations += refinement.iterations;
    if (!refinement.converged || !is_solution(x)) {
      const auto found = equations_.refine_where_flat(met.x, most);
      if (found) x = *found;
      if (!found || !is_solution(x)) falls_short("a crossing of t = 1 did not refine to a solution");
    }
    Candidate candidate{equations_.figure(x), 1};
    candidate.error = equations_.proven_error(candidate.figure);
    if (met.has_neighbour && !std::isfinite(candidate.error) && is_stiff(scene_, candidate.figure))
      falls_short(not_told_apart);
    return candidate;
  }

  const Scene& scene_;
  const TargetEquations& equations_;
  SolveReport report_;
  int proofs_left_ = 8;
};

}  // namespace

std::optional<std::string> why_no_path(const Scene& scene) {
  if (scene.problem().is_general())
    return "the path S is defined for points with distances between them alone";
  if (scene.has_lines()) return "the path S is defined for points only, and the scene has lines";
  if (!scene.sketch()) return "a path strategy starts from a sketch, and the instance has none";
  return std::nullopt;
}

std::unique_ptr<TargetEquations> target_distances(const Scene& scene,
                                                  std::function<Figure(const Eigen::VectorXd&)> figure_of) {
  return std::make_unique<TargetDistances>(scene, std::move(figure_of));
}

SolveReport path_report(const Scene& scene, const TrackedPath& path,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of) {
  return path_report(scene, path, TargetDistances(scene, figure_of));
}

SolveReport path_report(const Scene& scene, const TrackedPath& path, const TargetEquations& equations) {
  return PathReporter(scene, equations).run(path);
}

SolveReport report_of_newton(SolveReport path) {
  path.claim = Claim::some_real;
  path.paths.clear();
  return path;
}

SolveReport report_of_newton(const Scene& scene, const TrackedPath& path,
                             const std::function<Figure(const Eigen::VectorXd&)>& figure_of) {
  return report_of_newton(path_report(scene, path, figure_of));
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
