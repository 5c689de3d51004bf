#pragma once
/// Solutions next to a fold: a point that nearly is one, and at which the Jacobian loses rank. On the path S
/// it is an extremum of t next to t = 1; of the ends of two paths it is where they meet.
///
/// There the Jacobian f_x of the m equations in m coordinates has a kernel v, the direction of S, and a left
/// kernel w. With f at the target lengths, f(x + s v) = f(x) + s f_x v + s²/2 f''(v, v) exactly, since f is
/// quadratic: next to the fold there are solutions at s² = −2 w·f / w·f''(v, v) but for higher terms. The
/// residual is taken in double-double of the exact lengths, so that s² is right to the square of the rounding
/// of x, and s² > 0 can be told from s² < 0 down to |s| of a few ten roundings: where doubles know nothing.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "solvers/model/distance_system.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

struct FoldSolutions {
  Eigen::VectorXd direction;  ///< v, a unit vector
  /// Real ones, none or two: in the direction −v of the fold, and in that of v.
  std::vector<Eigen::VectorXd> x;
  std::vector<double>
      errors{};  ///< of the figures of these, in the scene's unit; empty where they are not proven
};

/// `near`: the fold, in the coordinates of the system and the scene's unit, as well as it is known. Nothing
/// where two real solutions and none are not told apart: at a double solution to the rounding of coordinates,
/// or where `near` is near no fold whose second derivative says so. Adds to `work`.
std::optional<FoldSolutions> solutions_at_fold(const DistanceSystem& system,
                                               const std::vector<DoubleDouble>& squares,
                                               const Eigen::VectorXd& near, WorkCounters& work);

/// With the direction from the first of two to the second; nothing where only one is real.
std::optional<FoldSolutions> along_their_line(FoldSolutions solutions);

}  // namespace gcs
