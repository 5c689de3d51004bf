#pragma once
/// The distances of points in a solution of a part, to many digits.

#include <optional>

#include "solvers/model/scene.hpp"
#include "solvers/reduction/hung_point.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// Of the base's points, which are among those of a part that is a problem of its own: proven next to the places, in the
/// scene's unit, that a solution in doubles gives to its points. Nothing where that is complex, or not proven.
std::optional<MeasuredSquares> precise_base(const Scene& scene, const PartProblem& part,
                                            const Simplex& places, const std::vector<int>& base);

}  // namespace gcs
