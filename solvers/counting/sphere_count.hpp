#pragma once
/// The number of complex realisations of a scene of the plane on the sphere.

#include <optional>
#include <string>

#include "solvers/counting/theoretical_counts.hpp"

namespace gcs {

struct SphereCount {
  std::optional<SolutionCount> exact;  ///< in the fixed frame and up to reflection; signs are the plane's
  std::string why_no_exact;            ///< a sentence; empty when there is an exact count
};

/// Places on the unit sphere with generic distances in place of those given, one edge held fixed, which is another
/// number than in the plane, never a smaller one (Dewar, Grasegger 2023). Precondition: the problem is well posed.
SphereCount sphere_count(const ProblemStatement& problem, const RecursionLimits& limits = {});

}  // namespace gcs
