#pragma once
/// From a tracked path to a strategy's report; the same for every tracker of S.

#include <functional>
#include <optional>
#include <string>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/series_tracker.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// Why S cannot be tracked in this scene (lines, no sketch), or nothing.
std::optional<std::string> why_no_path(const Scene& scene);

/// Refines every crossing of t = 1 to full accuracy in the frame's coordinates and records it in path order;
/// next to an extremum of t near 1 the equations at the exact target lengths decide whether there are two
/// (fold_solutions.hpp). `figure_of`: the figure, in the scene's unit and any position, of a crossing's
/// point. A crossing that does not refine, or moves further than the tracker's accuracy explains, or that is
/// not told apart from its neighbour, makes the report partial and says so.
SolveReport path_report(const Scene& scene, const TrackedPath& path,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of);

/// The same of newton_from_sketch: no path, and a claim of some real solutions.
SolveReport report_of_newton(const Scene& scene, const TrackedPath& path,
                             const std::function<Figure(const Eigen::VectorXd&)>& figure_of);

/// What `track` reports; where a crossing did not refine, what it reports with a thousandth of the tolerance,
/// with the work of both. In a scene that nearly moves t hardly changes along S, so that an error of the
/// series moves a crossing far.
SolveReport report_once_refined(SeriesTrackerOptions options,
                                const std::function<SolveReport(const SeriesTrackerOptions&)>& track);

}  // namespace gcs
