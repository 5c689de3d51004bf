#pragma once
/// What two bodies share, and which directions they have in common by it.

#include <array>
#include <vector>

#include "solvers/elements/element_kinds.hpp"

namespace gcs {

/// Two bodies and what both have. In space
///
///   a point                            a ball
///   a line                             a cylinder
///   a plane, or parallel ones          a plane
///   points of one line, or a point on a line or with planes that are parallel, or a line and planes across it   a hinge
///   two planes that cross              a slide
///   a point, and points or planes that give two directions   no motion (of bodies with given positions)
///
/// and in the plane a point or a line.
struct BodyJoint {
  /// One that both have.
  struct Direction {
    std::array<BodyDirection, 2> in_bodies{};
    bool is_either_way = false;  ///< whether it may be the opposite one in the second
    int relation = -1;           ///< which gives it; −1: what both share
    int axis = -1;               ///< the number of what a body has given for it, see BodyOrder
    bool is_opposite = false;
  };
  std::array<int, 2> bodies{};
  std::vector<int> points, lines, planes;  ///< entities, in the order of the first body
  std::vector<Direction> directions;       ///< at most two, not parallel; none in the plane
  bool is_known = true;                    ///< whether it is one of those above

  bool joins(int body) const { return bodies[0] == body || bodies[1] == body; }
  int other(int body) const { return bodies[0] == body ? bodies[1] : bodies[0]; }
  const BodyDirection& in_body(const Direction& direction, int body) const {
    return direction.in_bodies[body == bodies[0] ? 0 : 1];
  }
  bool shares_something() const { return !points.empty() || !lines.empty() || !planes.empty(); }
};

/// All pairs of bodies that share something, and after them those that a relation gives one direction.
std::vector<BodyJoint> body_joints(const ProblemStatement& problem);

/// The direction, where the body has it; of length 1.
Eigen::Vector3d direction_in_body(const ProblemStatement& problem, const RigidBody& body,
                                  const BodyDirection& direction);
bool are_parallel_in_body(const ProblemStatement& problem, const RigidBody& body, const BodyDirection& a,
                          const BodyDirection& b);

}  // namespace gcs
