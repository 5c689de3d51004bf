#pragma once
/// From a tracked path to a strategy's report; the same for every tracker of S.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "solvers/figures/fold_solutions.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/series_tracker.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// Why S cannot be tracked in this scene (lines, no sketch), or nothing.
std::optional<std::string> why_no_path(const Scene& scene);

/// The equations at the target, in coordinates of their own.
class TargetEquations {
 public:
  virtual ~TargetEquations() = default;
  /// Of a tracker's point.
  virtual Eigen::VectorXd coordinates(const Eigen::VectorXd& point) const = 0;
  /// By Newton's method.
  virtual Refinement refine(Eigen::VectorXd& x) const = 0;
  /// Where that fails: the solution no further than `most` along the direction in which the equations change least, if
  /// there is a way that finds it (flat_refinement.hpp).
  virtual std::optional<Eigen::VectorXd> refine_where_flat(const Eigen::VectorXd& /*x*/,
                                                           double /*most*/) const {
    return std::nullopt;
  }
  /// As solutions_at_fold says.
  virtual std::optional<FoldSolutions> at_fold(const Eigen::VectorXd& near, WorkCounters& work) const = 0;
  /// The same by a proof in balls, with errors; nothing where it does not succeed, or doubles do not tell the two apart.
  virtual std::optional<FoldSolutions> proven_at_fold(const Eigen::VectorXd& near) const = 0;
  virtual Figure figure(const Eigen::VectorXd& x) const = 0;
  /// A proven bound on the error of a figure, or infinity.
  virtual double proven_error(const Figure& figure) const = 0;
};

/// Those of distances; `figure_of` as in path_report. The scene outlives them.
std::unique_ptr<TargetEquations> target_distances(const Scene& scene,
                                                  std::function<Figure(const Eigen::VectorXd&)> figure_of);

/// Refines every crossing of t = 1 to full accuracy in the frame's coordinates and records it in path order;
/// next to an extremum of t near 1 the equations at the exact target lengths decide whether there are two
/// (fold_solutions.hpp), and a proof in balls where double-double does not tell. `figure_of`: the figure, in
/// the scene's unit and any position, of a crossing's point. A crossing that does not refine, or moves
/// further than the tracker's accuracy explains, or that is not told apart from its neighbour, makes the
/// report partial and says so.
SolveReport path_report(const Scene& scene, const TrackedPath& path,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of);
/// The same with other equations.
SolveReport path_report(const Scene& scene, const TrackedPath& path, const TargetEquations& equations);

/// A report on Newton's method in place of a path: a claim of some real solutions.
SolveReport report_of_newton(SolveReport path);
/// That of newton_from_sketch.
SolveReport report_of_newton(const Scene& scene, const TrackedPath& path,
                             const std::function<Figure(const Eigen::VectorXd&)>& figure_of);

/// What `track` reports; where a crossing did not refine, what it reports with a thousandth of the tolerance,
/// with the work of both. In a scene that nearly moves t hardly changes along S, so that an error of the
/// series moves a crossing far.
SolveReport report_once_refined(SeriesTrackerOptions options,
                                const std::function<SolveReport(const SeriesTrackerOptions&)>& track);

}  // namespace gcs
