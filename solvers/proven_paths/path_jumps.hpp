#pragma once
/// Where a tracker left the path: its accepted points against the proven path.

#include <string>
#include <vector>

#include "solvers/proven_paths/proven_path.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// Between accepted points `step` − 1 and `step` (0: the start) the tracker passed from one place to another
/// that is not its neighbour. An arc of S is named by the number of crossings of t = 1 between the sketch and
/// it; nothing: the point is not on S.
struct PathJump {
  std::int64_t step = 0;
  double t = 0;  ///< at the first of the two points
  std::optional<int> from, to;
};

/// The steps whose ends are more than three times as far apart along S as in a straight line: an arc so bent
/// within one step is not followed either; and those that leave S or come back to it. `points`: (X, t) in the
/// scene's unit, in order; `arcs` and `crossings` those of the proven path. Points within `tolerance` of S
/// are on it.
std::vector<PathJump> find_jumps(const std::vector<Eigen::VectorXd>& points,
                                 const std::vector<ProvenArc>& arcs,
                                 const std::vector<PathCrossing>& crossings, double tolerance);

/// A sentence that names the first few.
std::string in_words(const std::vector<PathJump>& jumps);

}  // namespace gcs
