#include "solvers/elements/body_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/body_placing.hpp"
#include "solvers/elements/scene_frame.hpp"

namespace gcs {
namespace {

/// Below this sine directions are parallel: positions in two bodies agree as well, of the scene's size.
constexpr double parallel_sine = 1e-9;

class JointReader {
 public:
  JointReader(const ProblemStatement& problem, int a, int b) : problem_(problem) {
    joint_.bodies = {a, b};
    for (const BodyElement& element : body().elements)
      if (const RigidBody& other = problem.bodies[static_cast<std::size_t>(b)];
          std::ranges::find(other.elements, element.entity, &BodyElement::entity) != other.elements.end())
        share(element.entity);
  }

  BodyJoint run() {
    if (problem_.dimension == 3) find_directions();
    joint_.is_known = problem_.dimension == 3 ? is_known_in_space() : is_known_in_the_plane();
    return std::move(joint_);
  }

 private:
  const RigidBody& body() const { return problem_.bodies[static_cast<std::size_t>(joint_.bodies[0])]; }

  void share(int entity) {
    if (problem_.is_point(entity))
      joint_.points.push_back(entity);
    else if (problem_.is_line(entity))
      joint_.lines.push_back(entity);
    else
      joint_.planes.push_back(entity);
  }

  bool are_parallel(const BodyDirection& a, const BodyDirection& b) const {
    return are_parallel_in_body(problem_, body(), a, b);
  }

  void take(const BodyDirection& direction, bool is_either_way = false) {
    const auto is_new = [&](const BodyJoint::Direction& known) {
      return !are_parallel(known.in_bodies[0], direction);
    };
    if (joint_.directions.size() < 2 && std::ranges::all_of(joint_.directions, is_new))
      joint_.directions.push_back({{direction, direction}, is_either_way});
  }

  /// That of a line only where there is no other: its sign is open.
  void find_directions() {
    for (std::size_t i = 1; i < joint_.points.size(); ++i) take({joint_.points[0], joint_.points[i]});
    for (const int plane : joint_.planes) take({plane});
    if (joint_.directions.empty() && !joint_.lines.empty()) take({joint_.lines[0]}, true);
  }

  Eigen::Vector3d position(int entity) const {
    const ElementPosition at = position_in_body(problem_, element_of(body(), entity));
    const auto* line = std::get_if<LinePosition>(&at);
    return line == nullptr ? std::get<Eigen::Vector3d>(at) : line->point;
  }

  bool goes_through(int line, int point) const {
    const Eigen::Vector3d at = position(point), from = position(line);
    const Eigen::Vector3d along = direction_in_body(problem_, body(), {line});
    return along.cross(at - from).stableNorm() <= parallel_sine * (at.stableNorm() + from.stableNorm());
  }

  bool is_known_in_space() const {
    const auto& [points, lines, planes] = std::tie(joint_.points, joint_.lines, joint_.planes);
    if (joint_.directions.size() == 2) return !points.empty() || (lines.empty() && planes.size() == 2);
    if (lines.empty()) return true;
    return lines.size() == 1 && are_parallel(joint_.directions[0].in_bodies[0], {lines[0]}) &&
           (points.empty() || goes_through(lines[0], points[0]));
  }

  bool is_known_in_the_plane() const { return joint_.points.size() + joint_.lines.size() == 1; }

  const ProblemStatement& problem_;
  BodyJoint joint_;
};

}  // namespace

Eigen::Vector3d direction_in_body(const ProblemStatement& problem, const RigidBody& body,
                                  const BodyDirection& direction) {
  const auto at = [&](int entity) { return position_in_body(problem, element_of(body, entity)); };
  if (direction.to >= 0)
    return (std::get<Eigen::Vector3d>(at(direction.to)) - std::get<Eigen::Vector3d>(at(direction.from)))
        .stableNormalized();
  const ElementPosition position = at(direction.from);
  const auto* line = std::get_if<LinePosition>(&position);
  return line == nullptr ? std::get<PlanePosition>(position).normal : line->direction;
}

bool are_parallel_in_body(const ProblemStatement& problem, const RigidBody& body, const BodyDirection& a,
                          const BodyDirection& b) {
  return direction_in_body(problem, body, a).cross(direction_in_body(problem, body, b)).norm() <=
         parallel_sine;
}

std::vector<BodyJoint> body_joints(const ProblemStatement& problem) {
  std::vector<BodyJoint> joints;
  const int bodies = static_cast<int>(problem.bodies.size());
  for (int a = 0; a < bodies; ++a)
    for (int b = a + 1; b < bodies; ++b) {
      BodyJoint joint = JointReader(problem, a, b).run();
      if (joint.shares_something()) joints.push_back(std::move(joint));
    }
  for (const DirectionsMadeOne& made : directions_made_one(problem)) {
    BodyJoint joint;
    for (std::size_t i = 0; i < 2; ++i) joint.bodies[i] = bodies_with(problem, made.entities[i]).front();
    joint.directions.push_back(
        {{BodyDirection{made.entities[0]}, BodyDirection{made.entities[1]}}, true, made.relation});
    if (problem.dimension == 3 && joint.bodies[0] != joint.bodies[1]) joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace gcs
