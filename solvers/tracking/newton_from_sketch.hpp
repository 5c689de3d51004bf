#pragma once
/// Newton's method at the given lengths, begun at the sketch: what a path costs and finds more than that.

#include <fmt/format.h>

#include "solvers/tracking/euler_newton_tracker.hpp"

namespace gcs {

/// Newton's method for H(·, 1) = 0 from where the homotopy's path starts, undamped, with the Jacobian of every
/// iterate. The end as the only crossing of a path of no length; `failed`, with the reason, where it does not
/// settle or leaves the domain. [I] calls this what commercial solvers do; in the driving parameters of a plan
/// it is the method of its reference 4.
template <Homotopy H>
TrackedPath newton_from_sketch(H& homotopy, const TrackerContext& context) {
  constexpr int most_iterations = 200;
  constexpr double settled = 1e-10;  // relative to the unknowns, as the tracker's corrector at unit size
  TrackedPath path;
  WorkCounters& work = homotopy.work();
  const auto finish = [&](TrackedPath::End end, std::string cause) {
    path.end = end;
    path.cause = std::move(cause);
    path.work = work;
    return path;
  };
  Eigen::VectorXd y = homotopy.start();
  const Eigen::Index n = y.size() - 1;
  y[n] = 1;
  Eigen::VectorXd residual(n);
  Eigen::MatrixXd jacobian(n, n + 1);
  for (int i = 0; i < most_iterations; ++i) {
    if (context.stop.stop_requested()) return finish(TrackedPath::End::stopped, "stopped on request");
    if (!homotopy.residual(y, residual) || !homotopy.jacobian(y, residual, jacobian))
      return finish(
          TrackedPath::End::failed,
          fmt::format("Newton's method from the sketch left the plan's domain after {} iterations", i));
    const Eigen::VectorXd correction = jacobian.leftCols(n).partialPivLu().solve(residual);
    ++work.factorisations;
    ++work.newton_iterations;
    y.head(n) -= correction;
    if (!y.allFinite()) break;
    if (correction.norm() <= settled * y.head(n).norm()) {
      path.crossings.push_back({homotopy.figure_coordinates(y), 1});
      return finish(TrackedPath::End::reached, "");
    }
  }
  return finish(TrackedPath::End::failed, "Newton's method from the sketch does not settle");
}

}  // namespace gcs
