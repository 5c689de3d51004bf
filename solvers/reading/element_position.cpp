#include "solvers/reading/element_position.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

namespace gcs {
namespace {

using Conditions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Ratios below this come from rounding: coordinates have 16 digits, and differences lose one or two.
constexpr double rounding = 1e-14;

/// Sines below this are those of parallel elements. As far as this may positions disagree that are given twice.
constexpr double parallel_sine = 1e-9;

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
Eigen::Matrix<double, 2, 3> across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d first = direction.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> result;
  result << first.transpose(), direction.cross(first).transpose();
  return result;
}

/// How a direction turns.
Eigen::Matrix<double, 2, 6> turn(const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 2, 6> result = Eigen::Matrix<double, 2, 6>::Zero();
  for (int axis = 0; axis < 3; ++axis)
    result.col(3 + axis) = across(direction) * Eigen::Vector3d::Unit(axis).cross(direction);
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
    conditions << across(line.direction) * velocity_, turn(line.direction);
    return conditions;
  }
  Conditions operator()(const PlanePosition& plane) const {
    Conditions conditions(3, 6);
    conditions << plane.normal.transpose() * velocity_, turn(plane.normal);
    return conditions;
  }

 private:
  Eigen::Matrix<double, 3, 6> velocity_;
};

double distance_of_lines(const LinePosition& a, const LinePosition& b) {
  const Eigen::Vector3d normal = a.direction.cross(b.direction);
  const Eigen::Vector3d between = b.point - a.point;
  return normal.norm() <= parallel_sine ? between.cross(a.direction).stableNorm()
                                        : std::abs(between.dot(normal)) / normal.norm();
}

double height(const Eigen::Vector3d& point, const PlanePosition& plane) {
  return plane.normal.dot(point) - plane.offset;
}

/// Of two elements, the kind of the first not after that of the second in ElementPosition.
class Measuring {
 public:
  using Measures = std::vector<Measure>;

  Measures operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return {{true, (a - b).stableNorm()}};
  }
  Measures operator()(const Eigen::Vector3d& point, const LinePosition& line) const {
    return {{true, (point - line.point).cross(line.direction).stableNorm()}};
  }
  Measures operator()(const Eigen::Vector3d& point, const PlanePosition& plane) const {
    return {{true, height(point, plane)}};
  }
  Measures operator()(const LinePosition& a, const LinePosition& b) const {
    return {{false, std::abs(a.direction.dot(b.direction))}, {true, distance_of_lines(a, b)}};
  }
  Measures operator()(const LinePosition& line, const PlanePosition& plane) const {
    const double sine = std::abs(line.direction.dot(plane.normal));
    Measures result{{false, sine}};
    if (sine <= parallel_sine) result.push_back({true, height(line.point, plane)});
    return result;
  }
  Measures operator()(const PlanePosition& a, const PlanePosition& b) const {
    const double cosine = a.normal.dot(b.normal);
    Measures result{{false, cosine}};
    if (a.normal.cross(b.normal).norm() <= parallel_sine)
      result.push_back({true, b.offset * (cosine > 0 ? 1 : -1) - a.offset});
    return result;
  }
  template <typename A, typename B>
  Measures operator()(const A& a, const B& b) const {
    return (*this)(b, a);
  }
};

}  // namespace

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
  decomposition.setThreshold(rounding);
  return motions - static_cast<int>(decomposition.rank());
}

std::vector<Measure> measures(const ElementPosition& a, const ElementPosition& b) {
  return std::visit(Measuring(), a, b);
}

}  // namespace gcs
