#include "solvers/elements/pose_features.hpp"

#include "solvers/elements/body_motion.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

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

}  // namespace gcs
