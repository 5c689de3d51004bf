#pragma once
/// Two solutions so close together that the paths to them were not told apart.

#include <array>
#include <optional>

#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {

/// The solutions next to `mean`, which lies between them: Newton's method, with residuals in double-double,
/// from mean ± s v, where v is the direction that the equations f determine least at the mean, w the
/// combination of them that varies least there, and w·(f + s²/2 f''(v, v)) = 0. Nothing where it does not
/// lead to two solutions about 2s apart.
std::optional<std::array<ComplexVectorX, 2>> close_pair(const DistanceSystem& system,
                                                        const std::vector<DoubleDouble>& squares,
                                                        const ComplexVectorX& mean);

}  // namespace gcs
