#include "solvers/reading/sketch_pose.hpp"

#include "solvers/reading/element_position.hpp"

namespace gcs {

std::optional<std::vector<ElementPosition>> sketched_pose(
    const ProblemStatement& problem, const RigidBody& body,
    const std::vector<std::optional<Eigen::Vector3d>>& sketched) {
  std::vector<ElementPosition> all, known, seen;
  for (const BodyElement& element : body.elements) {
    all.push_back(position_in_body(problem, element));
    if (!problem.is_point(element.entity) || !sketched[element.entity]) continue;
    known.push_back(all.back());
    seen.emplace_back(*sketched[element.entity]);
  }
  if (motions_left(known, problem.dimension) > 0) return std::nullopt;
  const BodyMotion motion = nearest_motion(known, seen, problem.dimension);
  for (ElementPosition& position : all) position = motion(position);
  return all;
}

}  // namespace gcs
