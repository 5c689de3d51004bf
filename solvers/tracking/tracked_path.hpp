#pragma once
/// What a tracker of S brings back.

#include <Eigen/Core>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/work.hpp"

namespace gcs {

/// A point (X, t) at which S meets t = 1.
struct PathCrossing {
  Eigen::VectorXd point;
  int direction = 1;  ///< sign of dt along the path
};

struct TrackedPath {
  enum class End { closed, failed, stopped };
  End end = End::failed;
  std::string cause;  ///< a sentence, empty when closed
  double length = 0;  ///< arc length tracked, in the coordinates of the tracker
  std::vector<PathCrossing> crossings;
  std::vector<Eigen::VectorXd>
      points;           ///< accepted ones, the start first, where the tracker was to keep them
  bool proven = false;  ///< that it is closed, and the order and number of its crossings
  WorkCounters work;
};

/// The outside world of a tracker.
struct TrackerContext {
  std::stop_token stop;
  Monitor* monitor = nullptr;
};

}  // namespace gcs
