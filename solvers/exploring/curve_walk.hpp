#pragma once
/// One curve with a value released, from a solution to both ends or round to it again.

#include "solvers/exploring/explored_scene.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

struct WalkOptions {
  SeriesTrackerOptions tracking;
  bool proves = false;  ///< by tubes (proven_paths/certified_tracker.hpp), where they reach
};

/// The report has one path: closed, at infinity on both sides, singular (it cannot be followed past a point, the tracker
/// says where), failed or stopped; its crossings are candidates of the report, of which one is the solution itself. Proven
/// is, if anything, that it is closed, and the order and number of its crossings, for the numbers of the file. Where points
/// are kept of an unproven one, the report's one curve has them as figures.
/// `solution`: unknowns of a regular solution; `released`: an equation that gives a value.
SolveReport walk_curve(const Scene& scene, const ExploredScene& explored, Eigen::Index released,
                       const Eigen::VectorXd& solution, const WalkOptions& options,
                       const TrackerContext& context);

}  // namespace gcs
