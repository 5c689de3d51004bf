#pragma once
/// How far a real solution in doubles is from the solution that it stands for.

#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/double_double.hpp"

namespace gcs {

/// A proven bound on the error of a real figure in the scene's unit, up to a motion, by Krawczyk's test in
/// the smallest box that it holds in; for those that are stiff. Infinite for others, where nothing is proven,
/// for scenes with lines, and above 300 unknowns. `squares`: see target_squares.
double proven_error(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure);

}  // namespace gcs
