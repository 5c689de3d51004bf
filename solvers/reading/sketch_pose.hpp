#pragma once
/// Where a sketch has the elements of a body that it does not name.

#include <optional>
#include <vector>

#include "solvers/reading/element_position.hpp"

namespace gcs {

/// The rigid motion, without a reflection, that brings the body's points nearest to those that a sketch gives, applied
/// to all its elements: one position for each, in their order. `sketched`: of every point of the problem the position
/// that is given. Nothing where these points do not determine the pose.
std::optional<std::vector<ElementPosition>> sketched_pose(
    const ProblemStatement& problem, const RigidBody& body,
    const std::vector<std::optional<Eigen::Vector3d>>& sketched);

}  // namespace gcs
