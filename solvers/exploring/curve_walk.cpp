#include "solvers/exploring/curve_walk.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/proven_paths/general_path_data.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/released_curve.hpp"
#include "solvers/tracking/whole_curve.hpp"

namespace gcs {
namespace {

class CurveWalk {
 public:
  CurveWalk(const Scene& scene, const ExploredScene& explored, Eigen::Index released,
            const Eigen::VectorXd& solution, const TrackerContext& context)
      : scene_(scene), explored_(explored), released_(released), solution_(solution), context_(context) {}

  /// Once more from beside the solution where not all is told from there, as next to a fold that the curve begins at.
  SolveReport by_series(const SeriesTrackerOptions& options) const {
    SolveReport report = by_series_from(
        [this](const SeriesTrackerOptions& of_half) { return curve_from_solution(of_half); }, options);
    if (report.status != SolveStatus::partial) return report;
    const std::optional<Eigen::VectorXd> start = beside_solution(options);
    if (!start) return report;
    SolveReport again = by_series_from(
        [&](const SeriesTrackerOptions& of_half) { return curve_from_figure(*start, of_half); }, options);
    if (again.status != SolveStatus::complete) {
      add(again.work, report.work);
      return report;
    }
    add(report.work, again.work);
    return again;
  }

  /// Nothing where the curve is not proven to be closed, or a crossing is not settled.
  std::optional<SolveReport> by_tubes(const SeriesTrackerOptions& options, WorkCounters& work) const {
    const std::optional<Eigen::VectorXd> start = beside_solution(options);
    if (!start) return std::nullopt;
    CertifiedTracker tracker(provable_curve_from(*start, options), options, context_);
    SolveReport report = path_report(scene_, tracker.run(), explored_.target());
    add(report.work, work);
    if (report.status != SolveStatus::complete) return std::nullopt;
    return report;
  }

 private:
  using BeginCurve = std::function<ReleasedCurve(const SeriesTrackerOptions&)>;

  SolveReport by_series_from(const BeginCurve& begin, const SeriesTrackerOptions& options) const {
    const FollowCurve follow = [&](const SeriesTrackerOptions& of_half) {
      ReleasedCurve curve = begin(of_half);
      return SeriesTracker(curve, of_half, context_).run();
    };
    return report_once_refined(options, [&](const SeriesTrackerOptions& refined) {
      const TrackedPath path = whole_curve(follow, refined);
      SolveReport report = path_report(scene_, path, explored_.target());
      if (!path.points.empty()) report.curves.push_back(curve_record(path, report));
      return report;
    });
  }

  Figure figure_at(const Eigen::VectorXd& y) const {
    return explored_.target().figure(explored_.target().coordinates(y));
  }

  /// The figures; of each crossing the place of the nearest one, of which the tracker kept its point.
  CurveRecord curve_record(const TrackedPath& path, const SolveReport& report) const {
    CurveRecord record;
    for (const Eigen::VectorXd& y : path.points) record.figures.push_back(figure_at(y));
    for (const Crossing& crossing : report.paths.front().crossings) {
      const auto& points = report.candidates[static_cast<std::size_t>(crossing.candidate)].figure.points;
      const auto nearest = std::ranges::min_element(
          record.figures, {}, [&](const Figure& figure) { return (figure.points - points).squaredNorm(); });
      record.places.push_back(static_cast<std::size_t>(nearest - record.figures.begin()));
    }
    return record;
  }

  ReleasedCurve curve_from_solution(const SeriesTrackerOptions& options) const {
    return {ReleasedFamily::at_solution(explored_.equations(), explored_.signs(), released_, solution_,
                                        options.order),
            options.tolerance};
  }

  ReleasedCurve curve_from_figure(const Eigen::VectorXd& start, const SeriesTrackerOptions& options) const {
    return {
        ReleasedFamily::at_figure(explored_.equations(), explored_.signs(), released_, start, options.order),
        options.tolerance};
  }

  /// A point of the curve where it meets no crossing.
  std::optional<Eigen::VectorXd> beside_solution(const SeriesTrackerOptions& options) const {
    ReleasedCurve curve = curve_from_solution(options);
    ArcSeries series(curve.coordinates(), options.order), there = series;
    if (!curve.start(options.orientation, series)) return std::nullopt;
    Eigen::VectorXd y, tangent;
    const double reach = std::min({options.step_max, series.step_for(options.tolerance), series.radius()});
    for (double step = reach / 2; step >= least_step; step /= 2) {
      series.evaluate(step, y);
      series.tangent(step, tangent);
      if (curve.advance(y, tangent, there, false)) return y.head(y.size() - 1);
    }
    return std::nullopt;
  }

  std::unique_ptr<ProvableCurve> provable_curve_from(const Eigen::VectorXd& start,
                                                     const SeriesTrackerOptions& options) const {
    ProvableEquations exact{released_equations(explored_.exact()),
                            enclose_released_data(explored_.exact(), released_, start), explored_.signs()};
    if (!exact.data.is_finite()) exact.no_start = "no figure on the curve is proven beside the solution";
    return std::make_unique<FollowedCurve<ReleasedCurve>>(
        std::move(exact), curve_from_figure(start, options),
        [this](const Eigen::VectorXd& y) { return figure_at(y); });
  }

  const Scene& scene_;
  const ExploredScene& explored_;
  Eigen::Index released_;
  const Eigen::VectorXd& solution_;
  const TrackerContext& context_;
};

}  // namespace

SolveReport walk_curve(const Scene& scene, const ExploredScene& explored, Eigen::Index released,
                       const Eigen::VectorXd& solution, const WalkOptions& options,
                       const TrackerContext& context) {
  const CurveWalk walk(scene, explored, released, solution, context);
  WorkCounters unproven;
  if (options.proves)
    if (auto proven = walk.by_tubes(options.tracking, unproven)) return *std::move(proven);
  SolveReport report = walk.by_series(options.tracking);
  PathRecord& path = report.paths.front();
  if (path.end == PathRecord::End::failed && report.work.iterations < options.tracking.max_steps)
    path.end = PathRecord::End::singular;
  add(unproven, report.work);
  return report;
}

}  // namespace gcs
