#include "solvers/reading/sketch_pose.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "solvers/reading/instance_bodies.hpp"

namespace gcs {
namespace {

/// x ↦ turn·x + shift.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  ElementPosition operator()(const Eigen::Vector3d& point) const {
    return Eigen::Vector3d(turn * point + shift);
  }
  ElementPosition operator()(const LinePosition& line) const {
    return LinePosition{turn * line.point + shift, turn * line.direction};
  }
  ElementPosition operator()(const PlanePosition& plane) const {
    const Eigen::Vector3d normal = turn * plane.normal;
    return PlanePosition{normal, plane.offset + normal.dot(shift)};
  }
};

/// In a unit in which no product overflows.
Motion nearest_motion(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, int dimension) {
  const double unit = std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
  const Eigen::MatrixXd found = Eigen::umeyama(Eigen::MatrixXd(from.topRows(dimension) / unit),
                                               Eigen::MatrixXd(to.topRows(dimension) / unit), false);
  Motion motion;
  motion.turn.topLeftCorner(dimension, dimension) = found.topLeftCorner(dimension, dimension);
  motion.shift.head(dimension) = unit * found.topRightCorner(dimension, 1);
  return motion;
}

}  // namespace

std::optional<std::vector<ElementPosition>> sketched_pose(
    const ProblemStatement& problem, const RigidBody& body,
    const std::vector<std::optional<Eigen::Vector3d>>& sketched) {
  std::vector<ElementPosition> all, known;
  Eigen::Matrix3Xd from(3, 0), to(3, 0);
  for (const BodyElement& element : body.elements) {
    all.push_back(position_in_body(problem, element));
    if (!problem.is_point(element.entity) || !sketched[element.entity]) continue;
    known.push_back(all.back());
    from.conservativeResize(3, from.cols() + 1);
    to.conservativeResize(3, to.cols() + 1);
    from.rightCols<1>() = std::get<Eigen::Vector3d>(all.back());
    to.rightCols<1>() = *sketched[element.entity];
  }
  if (motions_left(known, problem.dimension) > 0) return std::nullopt;
  const Motion motion = nearest_motion(from, to, problem.dimension);
  for (ElementPosition& position : all) position = std::visit(motion, position);
  return all;
}

}  // namespace gcs
