#include "solvers/elements/body_motion.hpp"

#include <Eigen/Geometry>
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

using Conditions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Ratios below this come from rounding: coordinates have 16 digits, and differences lose one or two.
constexpr double rank_rounding = 1e-14;

/// A point of the element near `near`.
class SomePoint {
 public:
  explicit SomePoint(Eigen::Vector3d near) : near_(std::move(near)) {}

  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const { return point; }
  Eigen::Vector3d operator()(const LinePosition& line) const { return line.point; }
  Eigen::Vector3d operator()(const PlanePosition& plane) const {
    return near_ - (plane.normal.dot(near_) - plane.offset) * plane.normal;
  }

 private:
  Eigen::Vector3d near_;
};

/// One point of each element.
std::vector<Eigen::Vector3d> some_points(const std::vector<ElementPosition>& elements) {
  std::vector<Eigen::Vector3d> points;
  for (const ElementPosition& element : elements)
    points.push_back(
        std::visit(SomePoint(points.empty() ? Eigen::Vector3d::Zero() : points.front()), element));
  return points;
}

/// Coordinates relative to the first position and divided by the largest, so that no product overflows.
class Normalisation {
 public:
  explicit Normalisation(const std::vector<Eigen::Vector3d>& positions)
      : half_origin_(positions.front() / 2) {
    double extent = 0;
    for (const Eigen::Vector3d& position : positions)
      extent = std::max(extent, (position / 2 - half_origin_).cwiseAbs().maxCoeff());
    if (extent > 0) half_scale_ = extent;
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& position) const {
    return (position / 2 - half_origin_) / half_scale_;
  }

 private:
  Eigen::Vector3d half_origin_;
  double half_scale_ = 1;
};

/// The velocity of a point by a rigid motion (translation, rotation).
Eigen::Matrix<double, 3, 6> velocity(const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 3, 6> result;
  result << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  for (int axis = 0; axis < 3; ++axis) result.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(point);
  return result;
}

/// Two directions that span all that are perpendicular to this one.
Eigen::Matrix<double, 2, 3> two_across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d first = direction.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> result;
  result << first.transpose(), direction.cross(first).transpose();
  return result;
}

/// How a direction turns.
Eigen::Matrix<double, 2, 6> turning_of(const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 2, 6> result = Eigen::Matrix<double, 2, 6>::Zero();
  for (int axis = 0; axis < 3; ++axis)
    result.col(3 + axis) = two_across(direction) * Eigen::Vector3d::Unit(axis).cross(direction);
  return result;
}

/// Linear conditions on a rigid motion: it leaves the element, which goes through that point, where it is. The plane's
/// three motions are the translations along x and y and the rotation about z.
class StillnessConditions {
 public:
  explicit StillnessConditions(const Eigen::Vector3d& through) : velocity_(velocity(through)) {}

  Conditions operator()(const Eigen::Vector3d&) const { return velocity_; }
  Conditions operator()(const LinePosition& line) const {
    Conditions conditions(4, 6);
    conditions << two_across(line.direction) * velocity_, turning_of(line.direction);
    return conditions;
  }
  Conditions operator()(const PlanePosition& plane) const {
    Conditions conditions(3, 6);
    conditions << plane.normal.transpose() * velocity_, turning_of(plane.normal);
    return conditions;
  }

 private:
  Eigen::Matrix<double, 3, 6> velocity_;
};

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

int motions_left(const std::vector<ElementPosition>& elements, int dimension) {
  const int motions = dimension == 2 ? 3 : 6;
  if (elements.empty()) return motions;
  const std::vector<Eigen::Vector3d> points = some_points(elements);
  const Normalisation normalise(points);
  Conditions conditions(0, 6);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Conditions more = std::visit(StillnessConditions(normalise(points[i])), elements[i]);
    conditions.conservativeResize(conditions.rows() + more.rows(), 6);
    conditions.bottomRows(more.rows()) = more;
  }
  Eigen::MatrixXd wanted = conditions;
  if (dimension == 2) wanted = conditions(Eigen::all, std::vector<int>{0, 1, 5}).eval();
  Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(wanted);
  decomposition.setThreshold(rank_rounding);
  return motions - static_cast<int>(decomposition.rank());
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
