#include "solvers/elements/pose_features.hpp"

#include <Eigen/LU>

#include "solvers/elements/body_motion.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

Eigen::Vector3cd second_vector(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, int dimension) {
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  return dimension == 2 ? cross_product(up, a) : b;
}

}  // namespace

BodyVectors body_vectors(const ProblemStatement& problem, const RigidBody& body, int exponent, int origin) {
  BodyVectors result;
  std::vector<BodyVector> points, normals;
  for (const BodyElement& element : body.elements) {
    const ElementPosition position = position_in_body(problem, element, exponent);
    if (const auto* plane = std::get_if<PlanePosition>(&position))
      normals.push_back({plane->normal.cast<std::complex<double>>(), element.entity});
    const auto* point = std::get_if<Eigen::Vector3d>(&position);
    if (point != nullptr) points.push_back({point->cast<std::complex<double>>(), element.entity});
  }
  for (const BodyVector& point : points)
    if (result.origin < 0 && (origin < 0 || point.entity == origin)) {
      result.origin = point.entity;
      result.origin_given = point.given;
    }
  for (const BodyVector& point : points)
    if (point.entity != result.origin)
      result.vectors.push_back({point.given - result.origin_given, point.entity});
  result.vectors.insert(result.vectors.end(), normals.begin(), normals.end());
  return result;
}

Eigen::Vector3cd moved_vector(const BodyVector& vector, int origin, const Placement& placement) {
  const auto points = placement.points.cols();
  const auto lines = static_cast<Eigen::Index>(placement.lines.size());
  if (vector.entity < points) return placement.points.col(vector.entity) - placement.points.col(origin);
  return placement.planes[static_cast<std::size_t>(vector.entity - points - lines)].normal;
}

Eigen::Matrix3cd triad(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
  Eigen::Matrix3cd result;
  result << a, b, cross_product(a, b);
  return result;
}

PoseFeatures pose_features(const ProblemStatement& problem, const RigidBody& body, int exponent) {
  PoseFeatures features{body_vectors(problem, body, exponent), {}, {}};
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  for (const BodyVector& a : features.from.vectors)
    for (const BodyVector& b : features.from.vectors) {
      const double area = cross_product(a.given, problem.dimension == 2 ? up : b.given).norm();
      if (!(area > features.area)) continue;
      features.area = area;
      features.first = a;
      features.second = b;
    }
  return features;
}

BodyPose body_pose(const PoseFeatures& body, const Placement& placement, int dimension) {
  const auto triad_of = [dimension](const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
    return triad(a, second_vector(a, b, dimension));
  };
  const int from = body.from.origin;
  const Eigen::Matrix3cd axes =
      triad_of(moved_vector(body.first, from, placement), moved_vector(body.second, from, placement)) *
      triad_of(body.first.given, body.second.given).inverse();
  return {placement.points.col(from) - axes * body.from.origin_given, axes};
}

}  // namespace gcs
