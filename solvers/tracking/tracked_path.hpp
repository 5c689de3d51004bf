#pragma once
/// What a tracker of S brings back.

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/model/interpolation.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// A point (X, t) at which S meets t = 1.
struct PathCrossing {
  Eigen::VectorXd point;
  int direction = 1;  ///< sign of dt along the path
  double at = 0;      ///< arc length from the sketch, in the coordinates of the tracker; 0: not kept
};

/// An extremum of t along S, so near t = 1 that the tracker cannot tell whether S crosses t = 1 twice next to
/// it or not at all.
struct PathTouch {
  Eigen::VectorXd point;
  Eigen::VectorXd before;  ///< a point of S shortly before
  int direction = 1;       ///< sign of dt before the extremum
  double at = 0;           ///< arc length, as of a crossing
  double reach = 0;        ///< a crossing further from here is another one; infinite: not known
};

/// Where t stops growing along S.
struct PathFold {
  Eigen::VectorXd point;
  TimeRange t;  ///< the extremum is within it: proven with the path, else by an estimate of the error
};

struct TrackedPath {
  enum class End { closed, reached, at_infinity, failed, stopped };
  End end = End::failed;  ///< reached: the solution, or the fold, at which the tracker was to stop
  std::string cause;      ///< a sentence where it failed or was stopped
  double length = 0;      ///< arc length tracked, in the coordinates of the tracker
  std::vector<PathCrossing> crossings;
  std::optional<PathFold> fold;    ///< of a tracker that was to stop there
  std::vector<PathTouch> touches;  ///< what the tracker takes for crossings near them is in `crossings` too
  /// Accepted ones, the start first, where the tracker was to keep them.
  std::vector<Eigen::VectorXd> points;
  /// That it is closed, and the order and number of its crossings; or that t grows all the way to its end, a fold or the
  /// only crossing.
  bool proven = false;
  WorkCounters work;
};

/// A tracker gives up below this step, in the unit of its largest: near a singular point of S none is short
/// enough, and elsewhere steps are longer by orders of magnitude. δmin of [I].
inline constexpr double least_step = 1e-10;

/// The cause of giving up so.
inline std::string step_too_small(double t) {
  return "the step became too small near t = " + std::to_string(t);
}

/// Why a tracker gives S up where its t is beyond `far`, of which see times_far_away; nothing where it is not.
inline std::optional<std::string> runs_off(const TimeRange& far, double t) {
  if (t > far.low && t < far.high) return std::nullopt;
  return "S runs off to t = " + std::string(t > 0 ? "" : "-") +
         "infinity: no length vanishes on that side (hypothesis h2)";
}

/// Why a fold is not told from a solution.
inline constexpr const char* touches_target =
    "t stops growing so near to 1 that it is not known whether there is a solution";

/// The outside world of a tracker.
struct TrackerContext {
  std::stop_token stop;
  Monitor* monitor = nullptr;
};

}  // namespace gcs
