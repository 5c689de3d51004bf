#pragma once
/// Solutions next to an extremum of t on S that is next to t = 1.
///
/// There the Jacobian f_x of the m equations in m coordinates has a kernel v, the direction of S, and a left
/// kernel w. With f at the target lengths, f(x + s v) = f(x) + s f_x v + s²/2 f''(v, v) exactly, since f is
/// quadratic: at the extremum, S meets t = 1 at s² = −2 w·f / w·f''(v, v) but for higher terms. The residual
/// is taken in double-double of the exact lengths, so that s² is right to the square of the rounding of x,
/// and s² > 0 can be told from s² < 0 down to |s| of a few ten roundings: where a series in doubles knows
/// nothing.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "solvers/model/distance_system.hpp"
#include "solvers/work.hpp"

namespace gcs {

struct TouchingSolutions {
  Eigen::VectorXd direction;       ///< v, a unit vector
  std::vector<Eigen::VectorXd> x;  ///< none or two: in the direction −v of the extremum, and in that of v
};

/// `near`: the extremum, in the coordinates of the system and the scene's unit, as well as it is known.
/// Nothing where two solutions and none are not told apart: S touches t = 1 to the rounding of coordinates,
/// or `near` is near no extremum of t that is one by its second derivative. Adds to `work`.
std::optional<TouchingSolutions> solutions_at_touch(const DistanceSystem& system,
                                                    const std::vector<DoubleDouble>& squares,
                                                    const Eigen::VectorXd& near, WorkCounters& work);

}  // namespace gcs
