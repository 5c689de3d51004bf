#pragma once
/// Points of S from a tracker that knows of no tubes, and whether points of S keep to a polyline as it says.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "solvers/proven_paths/proven_path.hpp"
#include "solvers/tracking/euler_newton_tracker.hpp"
#include "solvers/tracking/paper_homotopies.hpp"

namespace gcs::samples {

/// Euler-Newton as published, with a largest step in the file's unit. Its points, (X, t) in the scene's unit,
/// are kept.
inline TrackedPath followed_path(const Scene& scene, double step_max) {
  PaperDistanceHomotopy homotopy(scene);
  EulerNewtonOptions options;
  options.step_max = step_max;
  options.keep_points = true;
  TrackedPath path = EulerNewtonTracker(homotopy, options, {}).run();
  REQUIRE(path.end == TrackedPath::End::closed);
  for (Eigen::VectorXd& y : path.points) y.head(y.size() - 1) *= std::ldexp(1.0, -scene.unit_exponent());
  return path;
}

inline double distance_from_segment(const Eigen::VectorXd& point, const Eigen::VectorXd& a,
                                    const Eigen::VectorXd& b) {
  const double along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (point - a - along * (b - a)).norm();
}

/// Every point, in the order of the path, is within `part` of a segment's radius, and `slack`, of that
/// segment, where the segments never go back; and the last point so near to the last one.
inline bool keeps_along(const std::vector<Eigen::VectorXd>& points, const std::vector<PathNode>& nodes,
                        double slack, double part = 1) {
  std::size_t segment = 0;
  const auto is_near = [&](const Eigen::VectorXd& point) {
    return distance_from_segment(point, nodes[segment].point, nodes[segment + 1].point) <=
           part * nodes[segment].radius + slack;
  };
  for (const Eigen::VectorXd& point : points)
    while (!is_near(point))
      if (++segment + 1 >= nodes.size()) return false;
  segment = nodes.size() - 2;
  return is_near(points.back());
}

}  // namespace gcs::samples
