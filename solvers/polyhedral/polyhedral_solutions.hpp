#pragma once
/// All solutions of a scene's equations for the lengths of a random placement, from mixed cells: zeros of
/// random coefficients (polyhedral_homotopies.hpp), then one homotopy in the coefficients to the equations.

#include <functional>
#include <random>
#include <stop_token>
#include <string>
#include <string_view>

#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/polyhedral/formulation.hpp"
#include "solvers/polyhedral/supports_paths.hpp"

namespace gcs {

struct PolyhedralSolutions {
  std::vector<ComplexVectorX> solutions;  ///< regular, distinct up to reflections, in the scene's coordinates
  std::string missing;                    ///< what may keep them from being all; empty when nothing does
  bool stopped = false;                   ///< on request, with an incomplete list
  PathCounts counts;
};

struct PolyhedralRequest {
  const Scene& scene;
  const DistanceSystem& coordinates;
  const SquareSystem& system;
  const ComplexVectorX& placement;  ///< whose lengths the equations have
  Formulation formulation = Formulation::spheres;
  bool follows_mirror_images = false;  ///< instead of dividing them out
  TrackingSetup setup;
  std::uint64_t seed = 0;
  std::stop_token stop;
  std::function<void(std::string_view stage, double fraction)> progress;
};

/// Adds to `work`.
PolyhedralSolutions polyhedral_solutions(const PolyhedralRequest& request, std::mt19937_64& random,
                                         WorkCounters& work);

}  // namespace gcs
