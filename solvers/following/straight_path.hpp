#pragma once
/// The arc of S on which t grows, from the sketch to the solution that it moves to.
///
/// Values go straight from those of the sketch (t = 0) to the given ones (t = 1). As long as t grows along the arc, the
/// figure is a continuous function of the values, and no other figure comes near: it does not flip. The arc ends at t = 1,
/// with the solution, or at a fold of t, beyond which there is no figure to move to.
///
/// A proof is a chain of tubes along which t is proven to grow (proven_paths/certified_tracker.hpp), from the sketch's
/// decimals to the file's. It fails where the arc is singular or nearly so; then, and without one, the arc is that of the
/// series tracker (tracking/series_tracker.hpp).

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// How the arc is followed.
struct ArcSettings {
  bool prove = true;
  int order = 12;           ///< of the series, 4 to 40
  double tolerance = 1e-7;  ///< size of the last terms of the series, in units of the scene
  std::int64_t max_steps = 1'000'000;
};

/// folds: t stops growing before it is 1. undecided: it may or may not; or the arc is singular, or has no start.
enum class ArcEnd { reached, folds, undecided, unsupported, stopped };

struct StraightArc {
  ArcEnd end = ArcEnd::undecided;
  std::string reason;  ///< unless reached or folds
  bool proven = false;
  std::string why_unproven;  ///< where that was asked for
  Figure figure;  ///< where it ends, in the scene's frame and unit; of an arc that is reached or folds
  /// A proven bound on the distance of its elements from where the arc ends, in the scene's unit, as SceneSystem::distance
  /// says.
  double error = std::numeric_limits<double>::infinity();
  TimeRange fold{};  ///< what t is at a fold, proven with the arc
  /// How the values travel, in the scene's unit: constraints, then relations. Nothing of what has no value.
  std::vector<std::optional<LengthPath>> values;
  WorkCounters work;
};

/// Precondition: no length of the scene is bent.
StraightArc follow_straight(const Scene& scene, const ArcSettings& settings, const TrackerContext& context);

}  // namespace gcs
