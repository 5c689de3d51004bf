#pragma once
/// The equations of a general scene with a tracker for them, a member at random and its solutions, and the way from these
/// to the values that the file gives.

#include <string>
#include <vector>

#include "solvers/elements/general_structure.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// A scene whose solutions are sought, with its equations. Precondition: !why_not_general(scene). The scene outlives this.
struct GivenScene {
  explicit GivenScene(const Scene& scene) : system(scene), equations(general_equations(system)) {}

  SceneSystem system;
  GeneralEquations equations;
};

/// Not to be moved: trackers refer to the system.
class GeneralStart {
 public:
  /// With equations as one scene has them.
  GeneralStart(GeneralEquations given, std::uint64_t seed, const TrackingSetup& setup);
  GeneralStart(const GeneralStart&) = delete;
  GeneralStart& operator=(const GeneralStart&) = delete;

  /// Whether another scene has the same equations but for its values.
  bool serves(const GivenScene& given) const;
  /// Every solution followed to the values of the request's scene, `given`, which it serves.
  SolveReport carried_to_values(const SolveRequest& request, const GivenScene& given,
                                const std::function<void(double)>& progress);

  std::mt19937_64 random;
  GeneralEquations equations;
  HomotopyFamily family;
  Elimination elimination;
  LegTracking tracking;
  WorkCounters work;
  ComplexVectorX parameters;              ///< of the member at random
  std::vector<ComplexVectorX> solutions;  ///< its regular ones, distinct up to signs
  std::string missing;      ///< what may keep them from being all, in words; empty when nothing does
  bool is_stopped = false;  ///< whether that is a stop on request
  std::vector<Particular> particulars;  ///< how they were found
};

}  // namespace gcs
