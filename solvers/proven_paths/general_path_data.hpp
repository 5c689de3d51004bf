#pragma once
/// Where S of a general scene begins and how its values run, for the exact numbers of the file.
///
/// A sketch need not meet the equations that have no value, and the doubles x̃ that it is moved to meet them to rounding
/// only. S begins at the one point x̂ beside x̃ at which they hold for the file's numbers, in the plane through x̃ that the
/// rows of their Jacobian span, rounded: Krawczyk's test shows that it is there. The values at t = 0 are those of x̂. What
/// is proven of S is thus proven of the path from x̂ to the file's values.

#include "solvers/proven_paths/path_data.hpp"
#include "solvers/tracking/general_curve.hpp"

namespace gcs {

/// `values` and `sketched` are those of a GeneralFamily. The result is not finite where the test fails, or a value without
/// a sign may be 0 at x̂.
PathData enclose_path_data(const Scene& scene, const SceneSystem& system,
                           const std::vector<TravellingValue>& values, const Eigen::VectorXd& sketched);

/// Of the curve of these equations with the value of one released, from the point of it beside `start`, found in the same
/// way, to where that equation is met at t = 1. Values are those of half the equations' sums, as released_equations has
/// them. Not finite where the test fails.
PathData enclose_released_data(const QuadraticSystem& equations, Eigen::Index released,
                               const Eigen::VectorXd& start);

}  // namespace gcs
