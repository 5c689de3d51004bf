#pragma once
/// Where a step of a scan plan can place its point at given angles, in doubles: the same positions, sides and
/// angles as step_pieces.hpp encloses over a cell.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// Where a point is that has given distances from two others.
struct HingeCircle {
  double offset = 0;  ///< of the centre from the first of the two, towards the second
  double radius = 0;
};

/// The circle at distance `a` from one point and `b` from another that is `base` away from it. Nothing where
/// the three are no triangle. The radius is the height over the base by Heron's formula, whose factors lose no
/// digits where the triangle is flat.
std::optional<HingeCircle> hinge_circle(double a, double b, double base);

/// At most four positions.
struct Places {
  std::array<Eigen::Vector3d, 4> at;
  int count = 0;

  void append(const Eigen::Vector3d& position) { at[static_cast<std::size_t>(count++)] = position; }
  const Eigen::Vector3d* begin() const { return at.data(); }
  const Eigen::Vector3d* end() const { return at.data() + count; }
};

/// Where the circle around the axis from `origin` in the unit direction `axis` meets the cylinder of radius
/// `around_line` around the x-axis.
Places meet_cylinder(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis, const HingeCircle& circle,
                     double around_line);

/// Where the distance of the circle's points from the x-axis has its minima and maxima.
Places extreme_distances_from_x_axis(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
                                     const HingeCircle& circle);

class StepPlaces {
 public:
  /// Keeps references.
  StepPlaces(const Scene& scene, const ScanPlan& plan);

  /// The positions of step k at its own angles, in radians; `points` (3 × point_count) holds the points placed
  /// before. Each once, those of one branch in a fixed order; none where the branch does not exist, or where
  /// centres coincide or are collinear.
  Places of(std::size_t k, const Eigen::Matrix3Xd& points, const std::array<double, 2>& angles) const;

  /// How far the point at `position` is from having the distance that the constraint gives.
  double excess(const ScanSphere& sphere, const Eigen::Vector3d& position,
                const Eigen::Matrix3Xd& points) const {
    return std::abs((position - points.col(sphere.center)).norm() - length(sphere.constraint));
  }

 private:
  double length(int constraint) const {
    return scene_.target_lengths()[static_cast<std::size_t>(constraint)];
  }
  /// The circle in which the step's first two spheres meet.
  struct Hinge {
    Eigen::Vector3d origin, axis;  ///< the first centre, and the unit direction to the second
    HingeCircle circle;

    Eigen::Vector3d center() const { return origin + circle.offset * axis; }
  };
  std::optional<Hinge> hinge(std::size_t k, const Eigen::Matrix3Xd& points) const;
  Places around_line(std::size_t k, const Eigen::Matrix3Xd& points, double angle) const;
  Places around_one(const ScanStep& step, const Eigen::Matrix3Xd& points,
                    const std::array<double, 2>& angles) const;
  Places on_circle(std::size_t k, const Eigen::Matrix3Xd& points, double angle) const;
  Places on_two_sides(std::size_t k, const Eigen::Matrix3Xd& points) const;

  const Scene& scene_;
  const ScanPlan& plan_;
  /// By step: the length that a constraint gives between its first two centres, the same in every placing.
  std::vector<std::optional<double>> given_bases_;
};

}  // namespace gcs
