#include "solvers/elements/body_motion.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

namespace gcs {
namespace {

/// Columns.
Eigen::Matrix3Xd points_of(const std::vector<ElementPosition>& elements) {
  Eigen::Matrix3Xd points(3, 0);
  for (const ElementPosition& element : elements)
    if (const auto* point = std::get_if<Eigen::Vector3d>(&element)) {
      points.conservativeResize(3, points.cols() + 1);
      points.rightCols<1>() = *point;
    }
  return points;
}

class Moved {
 public:
  explicit Moved(const BodyMotion& motion) : motion_(motion) {}

  ElementPosition operator()(const Eigen::Vector3d& point) const { return at(point); }
  ElementPosition operator()(const LinePosition& line) const {
    return LinePosition{at(line.point), motion_.turn * line.direction};
  }
  ElementPosition operator()(const PlanePosition& plane) const {
    const Eigen::Vector3d normal = motion_.turn * plane.normal;
    return PlanePosition{normal, plane.offset + normal.dot(motion_.shift)};
  }

 private:
  Eigen::Vector3d at(const Eigen::Vector3d& point) const { return motion_.turn * point + motion_.shift; }

  const BodyMotion& motion_;
};

}  // namespace

ElementPosition position_in_body(const ProblemStatement& problem, const BodyElement& element, int exponent) {
  const auto vector = [&](int first) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < problem.dimension; ++axis)
      result[axis] = element.numbers[static_cast<std::size_t>(first + axis)].value;
    return result;
  };
  const auto scale = [exponent](double length) { return std::ldexp(length, exponent); };
  if (problem.is_point(element.entity)) return Eigen::Vector3d(vector(0).unaryExpr(scale));
  if (problem.is_line(element.entity))
    return LinePosition{vector(0).unaryExpr(scale), vector(problem.dimension).stableNormalized()};
  const Eigen::Vector3d normal = vector(0);
  return PlanePosition{normal.stableNormalized(), scale(element.numbers[3].value) / normal.stableNorm()};
}

ElementPosition position_of(const ProblemStatement& problem, int entity, const Figure& figure) {
  if (problem.is_point(entity)) return Eigen::Vector3d(figure.points.col(entity));
  if (problem.is_line(entity)) return figure.lines[static_cast<std::size_t>(problem.line_of(entity))];
  return figure.planes[static_cast<std::size_t>(problem.plane_of(entity))];
}

void put(const ProblemStatement& problem, int entity, const ElementPosition& position, Figure& figure) {
  if (problem.is_point(entity))
    figure.points.col(entity) = std::get<Eigen::Vector3d>(position);
  else if (problem.is_line(entity))
    figure.lines[static_cast<std::size_t>(problem.line_of(entity))] = std::get<LinePosition>(position);
  else
    figure.planes[static_cast<std::size_t>(problem.plane_of(entity))] = std::get<PlanePosition>(position);
}

ElementPosition BodyMotion::operator()(const ElementPosition& position) const {
  return std::visit(Moved(*this), position);
}

BodyMotion nearest_motion(const std::vector<ElementPosition>& from, const std::vector<ElementPosition>& to,
                          int dimension) {
  Eigen::Matrix3Xd given = points_of(from), seen = points_of(to);
  // In a unit in which no product overflows.
  const double unit = std::max(given.cwiseAbs().maxCoeff(), seen.cwiseAbs().maxCoeff());
  if (unit > 0) {
    given /= unit;
    seen /= unit;
  }
  const Eigen::Vector3d middle = given.rowwise().mean(), seen_middle = seen.rowwise().mean();
  Eigen::Matrix3d product = (seen.colwise() - seen_middle) * (given.colwise() - middle).transpose();
  for (std::size_t i = 0; i < from.size(); ++i)
    if (const auto* plane = std::get_if<PlanePosition>(&from[i]))
      product += std::get<PlanePosition>(to[i]).normal * plane->normal.transpose();
  if (dimension == 2) product(2, 2) = 1 + product.norm();  // the largest singular value, which keeps its sign
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0)
    signs[2] = -1;  // of the smallest singular value
  BodyMotion motion;
  motion.turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  motion.shift = unit * (seen_middle - motion.turn * middle);
  return motion;
}

}  // namespace gcs
