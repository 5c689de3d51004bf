#pragma once
/// How far a solution in doubles is from the solution that it stands for.

#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/double_double.hpp"

namespace gcs {

/// A proven bound on the error of a figure in the scene's unit, up to a motion, for those that are stiff: of
/// a real one of points by Krawczyk's test in the smallest box that it holds in, of others by a certificate.
/// Infinite for others, where nothing is proven, and above 300 unknowns (100 for a certificate).
/// `squares`: see target_squares.
double proven_error(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure);

}  // namespace gcs
