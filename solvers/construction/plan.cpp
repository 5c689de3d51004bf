#include "solvers/construction/plan.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace gcs {
namespace {

/// Two circles in a plane with centres at distance `gap` on an axis: how far along that axis, and how far off
/// it, their intersection lies from the first centre. Differences of squares are factored so that nothing
/// cancels except at a tangency. False where the circles do not meet.
bool intersect_circles(double radius, double other, double gap, double& along, double& off) {
  if (!(gap > 0)) return false;
  along = gap / 2 + (radius - other) * (radius + other) / (2 * gap);
  const double square = (radius - along) * (radius + along);
  if (!(square >= 0)) return false;
  off = std::sqrt(square);
  return true;
}

bool place_in_plane(const Instruction& instruction, const std::array<double, 3>& radii,
                    Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d first = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d axis = center_of(instruction.spheres[1], points) - first;
  const double gap = axis.norm();
  double along = 0;
  double off = 0;
  if (!intersect_circles(radii[0], radii[1], gap, along, off)) return false;
  const Eigen::Vector3d n = axis / gap;
  points.col(instruction.place) =
      first + along * n + instruction.side * off * Eigen::Vector3d(-n.y(), n.x(), 0);
  return true;
}

/// interSS, then interCS.
bool place_in_space(const Instruction& instruction, const std::array<double, 3>& radii,
                    Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d first = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d axis = center_of(instruction.spheres[1], points) - first;
  const double gap = axis.norm();
  double along = 0;
  double circle = 0;
  if (!intersect_circles(radii[0], radii[1], gap, along, circle)) return false;
  const Eigen::Vector3d n = axis / gap;
  const Eigen::Vector3d center = first + along * n;

  const Eigen::Vector3d to_third = center_of(instruction.spheres[2], points) - center;
  const double height = to_third.dot(n);
  const Eigen::Vector3d in_plane = to_third - height * n;
  const double section = (radii[2] - height) * (radii[2] + height);
  const double plane_gap = in_plane.norm();
  if (!(section >= 0)) return false;
  double off = 0;
  if (!intersect_circles(circle, std::sqrt(section), plane_gap, along, off)) return false;
  const Eigen::Vector3d e = in_plane / plane_gap;
  points.col(instruction.place) = center + along * e + instruction.side * off * n.cross(e);
  return true;
}

}  // namespace

Plan::Plan(int dimension, int constraints, std::vector<Instruction> instructions)
    : dimension_(dimension), constraints_(constraints), instructions_(std::move(instructions)) {
  renew_indices();
}

void Plan::renew_indices() {
  std::vector<bool> used(static_cast<std::size_t>(constraints_), false);
  driven_before_.assign(1, 0);
  for (const Instruction& instruction : instructions_) {
    int driven = driven_before_.back();
    for (int i = 0; i < instruction.count; ++i) {
      if (instruction.spheres[i].is_driven())
        ++driven;
      else
        used[instruction.spheres[i].constraint] = true;
    }
    driven_before_.push_back(driven);
  }
  removed_.clear();
  for (int c = 0; c < constraints_; ++c)
    if (!used[c]) removed_.push_back(c);
}

Reference Plan::frame() const {
  Reference reference;
  for (const Instruction& instruction : instructions_) {
    if (instruction.count == 0) reference.origin = instruction.place;
    if (instruction.count == 1) reference.axis = instruction.place;
    if (instruction.count == 2 && dimension_ == 3) reference.plane = instruction.place;
  }
  return reference;
}

bool place(const Instruction& instruction, const std::array<double, 3>& radii, Eigen::Matrix3Xd& points) {
  switch (instruction.count) {
    case 0:
      points.col(instruction.place).setZero();
      return true;
    case 1:
      points.col(instruction.place) << radii[0], 0, 0;
      return radii[0] > 0;
    case 2:
      return place_in_plane(instruction, radii, points);
    default:
      return place_in_space(instruction, radii, points);
  }
}

int side_of(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  if (instruction.count < 2) return 1;
  const Eigen::Vector3d first = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d axis = center_of(instruction.spheres[1], points) - first;
  const Eigen::Vector3d to_point = points.col(instruction.place) - first;
  if (instruction.count == 2) return axis.x() * to_point.y() >= axis.y() * to_point.x() ? 1 : -1;
  const Eigen::Vector3d to_third = center_of(instruction.spheres[2], points) - first;
  return axis.cross(to_third).dot(to_point) >= 0 ? 1 : -1;
}

}  // namespace gcs
