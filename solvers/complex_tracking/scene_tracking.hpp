#pragma once
/// What the strategies for all complex solutions share: their options, a scene's equations with a tracker for
/// them, and the way from solutions at random lengths to those at the given ones.

#include <random>
#include <string>
#include <vector>

#include "solvers/complex_tracking/leg_tracking.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/strategy.hpp"

namespace gcs {

/// The options order, tolerance and instructions.
std::vector<OptionSpec> tracking_option_specs();
/// Their values, for one thread. Throws OptionError.
TrackingSetup tracking_setup(const OptionMap& options);

/// Why these strategies cannot place what the scene has, or nullopt.
std::optional<std::string> why_not_tracked(const Scene& scene);

/// Whether more than this many classes are impossible at generic lengths; nothing where nobody knows, or
/// where no list could be that long.
std::optional<std::uint64_t> most_classes(const Scene& scene);

/// Not to be moved or copied: the tracking refers to the other members.
class SceneTracking {
 public:
  SceneTracking(const Scene& scene, const TrackingSetup& setup, std::mt19937_64& random);
  SceneTracking(const SceneTracking&) = delete;
  SceneTracking& operator=(const SceneTracking&) = delete;

  const DistanceSystem& coordinates() const { return coordinates_; }
  const SquareSystem& system() const { return system_; }
  LegTracking& tracking() { return tracking_; }

  /// Follows solutions for the squared lengths `from`, distinct up to reflections and regular, to the lengths
  /// of the request, and reports their ends (complex_report.hpp). `work` is what has been done before.
  SolveReport solve(const std::vector<ComplexVectorX>& solutions, const ComplexVectorX& from,
                    const SolveRequest& request, WorkCounters work);

 private:
  DistanceSystem coordinates_;
  SquareSystem system_;
  Elimination elimination_;
  LegTracking tracking_;
};

}  // namespace gcs
