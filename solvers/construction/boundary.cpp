#include "solvers/construction/boundary.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace gcs {
namespace {

/// interCC, interSSP and interSS, or interCS within the plane of its circle: the point p on the circle of
/// that radius about `pivot`, and the line from `pivot` whose direction decides between the two
/// intersections.
struct Corner {
  Eigen::Vector3d point;
  Eigen::Vector3d pivot;
  Eigen::Vector3d foot;      ///< projection of p on the line
  Eigen::Vector3d sideways;  ///< unit, at a right angle to p − pivot, in the plane in which p is decided
  double radius = 0;         ///< |p − pivot|
  bool has_line = true;
};

Eigen::Vector3d projection(const Eigen::Vector3d& p, const Eigen::Vector3d& on,
                           const Eigen::Vector3d& direction) {
  return on + direction * (direction.dot(p - on) / direction.squaredNorm());
}

Eigen::Vector3d perpendicular(const Eigen::Vector3d& v, bool planar) {
  if (planar) return Eigen::Vector3d(-v.y(), v.x(), 0).stableNormalized();
  return v.unitOrthogonal();
}

Corner corner_of_two_spheres(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  Corner corner;
  corner.point = points.col(instruction.place);
  corner.pivot = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d direction = center_of(instruction.spheres[1], points) - corner.pivot;
  const Eigen::Vector3d arm = corner.point - corner.pivot;
  corner.radius = arm.norm();
  corner.has_line = direction.squaredNorm() > 0;
  corner.foot = corner.has_line ? projection(corner.point, corner.pivot, direction) : corner.pivot;
  // Gram–Schmidt of the line against the arm; where they are parallel, any perpendicular will do.
  const Eigen::Vector3d off_arm = direction - arm * (arm.dot(direction) / arm.squaredNorm());
  const bool parallel = !(off_arm.norm() > 1e-8 * direction.norm());
  corner.sideways =
      parallel ? perpendicular(arm, instruction.count == 2) : Eigen::Vector3d(off_arm.normalized());
  return corner;
}

Corner corner_of_circle_and_sphere(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  Corner corner;
  corner.point = points.col(instruction.place);
  const Eigen::Vector3d first = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d axis = (center_of(instruction.spheres[1], points) - first).stableNormalized();
  corner.pivot = first + axis * axis.dot(corner.point - first);
  const Eigen::Vector3d arm = corner.point - corner.pivot;
  corner.radius = arm.norm();
  const Eigen::Vector3d to_third = center_of(instruction.spheres[2], points) - corner.pivot;
  const Eigen::Vector3d direction = to_third - axis * axis.dot(to_third);
  // Nearer to the axis the difference is all rounding and points anywhere.
  corner.has_line = direction.norm() > 1e-8 * (to_third.norm() + corner.radius);
  corner.foot = corner.has_line ? projection(corner.point, corner.pivot, direction) : corner.pivot;
  corner.sideways = axis.cross(arm).stableNormalized();
  return corner;
}

Corner corner_of(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  return slot == 1 ? corner_of_two_spheres(instruction, points)
                   : corner_of_circle_and_sphere(instruction, points);
}

}  // namespace

double boundary_measure(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  const Corner corner = corner_of(instruction, slot, points);
  if (!corner.has_line) return 0;
  const double larger = std::max(corner.radius, radius_of(instruction, slot, points));
  return larger > 0 ? (corner.point - corner.foot).norm() / larger : 0;
}

double crossing_sine(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d p = points.col(instruction.place);
  const Eigen::Vector3d to_first = (center_of(instruction.spheres[0], points) - p).stableNormalized();
  const Eigen::Vector3d to_second = (center_of(instruction.spheres[1], points) - p).stableNormalized();
  const Eigen::Vector3d normal = to_first.cross(to_second);
  if (slot == 1) return normal.norm();
  const Eigen::Vector3d to_third = (center_of(instruction.spheres[2], points) - p).stableNormalized();
  return std::abs(normal.stableNormalized().dot(to_third));
}

std::optional<Eigen::Vector3d> shifted_reference(const Instruction& instruction, int slot,
                                                 const Eigen::Matrix3Xd& points, const ShiftRule& rule) {
  constexpr double nearest_angle = 0.5;  // cosine of 60 degrees: the sine stays above √3/2
  const Corner corner = corner_of(instruction, slot, points);
  const Eigen::Vector3d to_foot = corner.foot - corner.point;
  const double v = to_foot.norm();
  const bool is_defined = corner.has_line && v > 0;
  if (rule.towards_projection && !is_defined) return std::nullopt;
  const bool is_usable = is_defined && v > 1e-8 * corner.radius && v <= nearest_angle * corner.radius;
  const Eigen::Vector3d direction =
      rule.towards_projection || is_usable ? Eigen::Vector3d(to_foot / v) : corner.sideways;
  const double distance =
      rule.larger_radius ? std::max(corner.radius, radius_of(instruction, slot, points)) : corner.radius;
  return corner.point + distance * direction;
}

}  // namespace gcs
