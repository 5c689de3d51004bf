#pragma once
/// What tells the pose of a body from where its elements are.

#include "solvers/elements/placement.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A vector that moves with a body, from its origin to another point or along a plane's normal.
struct BodyVector {
  Eigen::Vector3cd given;
  int entity = -1;  ///< the other point, or the plane
};

/// A point, and the vectors from there, those to points first.
struct BodyVectors {
  int origin = -1;  ///< −1: the body has no point
  Eigen::Vector3cd origin_given = Eigen::Vector3cd::Zero();
  std::vector<BodyVector> vectors;
};

/// In a unit of 2^−exponent of the file's; the origin is the point `origin`, by default the body's first.
BodyVectors body_vectors(const ProblemStatement& problem, const RigidBody& body, int exponent,
                         int origin = -1);

/// Where a placement has a vector from that origin.
Eigen::Vector3cd moved_vector(const BodyVector& vector, int origin, const Placement& placement);

/// What tells the pose of a body: a point, and of all pairs of vectors the one of largest area; in the plane the second is
/// the first turned by a right angle.
struct PoseFeatures {
  BodyVectors from;
  BodyVector first, second;
  double area = 0;
};

PoseFeatures pose_features(const ProblemStatement& problem, const RigidBody& body, int exponent);

/// The body's coordinates c become origin + axes·c.
struct BodyPose {
  Eigen::Vector3cd origin;
  Eigen::Matrix3cd axes;
};

BodyPose body_pose(const PoseFeatures& body, const Placement& placement, int dimension);

/// Columns: a, b and their vector product.
Eigen::Matrix3cd triad(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b);

}  // namespace gcs
