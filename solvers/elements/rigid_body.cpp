#include <Eigen/LU>

#include "solvers/elements/element_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

Eigen::Vector3cd position(const BodyElement& element, double unit) {
  Eigen::Vector3cd result = Eigen::Vector3cd::Zero();
  for (std::size_t i = 0; i < element.numbers.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = element.numbers[i].value * unit;
  return result;
}

/// Columns: a vector, another one and their vector product; in the plane the second is the first turned by a right angle.
Eigen::Matrix3cd triad(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, int dimension) {
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  const Eigen::Vector3cd second = dimension == 2 ? cross_product(up, a) : b;
  Eigen::Matrix3cd result;
  result << a, second, cross_product(a, second);
  return result;
}

/// The points of a body, as the file says, that tell its pose best: the first, the one farthest from it, and the one
/// farthest from the line through both.
struct PosePoints {
  std::array<int, 3> point{};
  std::array<Eigen::Vector3cd, 3> at;
};

PosePoints pose_points(const RigidBody& body, double unit) {
  std::array<std::size_t, 3> chosen{};
  double farthest = -1, widest = -1;
  const auto at = [&](std::size_t i) { return position(body.elements[i], unit); };
  for (std::size_t i = 0; i < body.elements.size(); ++i)
    if (const double far = (at(i) - at(0)).norm(); far > farthest) {
      farthest = far;
      chosen[1] = i;
    }
  for (std::size_t i = 0; i < body.elements.size(); ++i)
    if (const double wide = cross_product(at(i) - at(0), at(chosen[1]) - at(0)).norm(); wide > widest) {
      widest = wide;
      chosen[2] = i;
    }
  PosePoints result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.point[k] = body.elements[chosen[k]].entity;
    result.at[k] = at(chosen[k]);
  }
  return result;
}

/// t, then the images of the axes.
struct Pose {
  Eigen::Vector3cd origin;
  Eigen::Matrix3cd axes;
};

Pose pose(const PosePoints& body, const Placement& placement, int dimension) {
  const auto image = [&](std::size_t k) -> Eigen::Vector3cd { return placement.points.col(body.point[k]); };
  const Eigen::Matrix3cd moved = triad(image(1) - image(0), image(2) - image(0), dimension);
  const Eigen::Matrix3cd given = triad(body.at[1] - body.at[0], body.at[2] - body.at[0], dimension);
  const Eigen::Matrix3cd axes = moved * given.inverse();
  return {image(0) - axes * body.at[0], axes};
}

/// Σ number_k·axis_k of a component.
LinearForm combined(LinearForm sum, const SystemBuilder& builder, const Decimal& number,
                    const LinearForm& axis) {
  if (number.value == 0) return sum;
  for (ScaledUnknown term : axis.terms) {
    ExactNumber coefficient = builder.length(number);
    coefficient.is_negative = term.coefficient.is_negative;
    sum.terms.push_back({term.unknown, coefficient});
  }
  return sum;
}

std::vector<BodyPoint> placed(const SystemBuilder& builder, const RigidBody& body, const VectorForm& origin,
                              const std::array<VectorForm, 3>& axes) {
  std::vector<BodyPoint> points;
  for (const BodyElement& element : body.elements) {
    BodyPoint point{element.entity, origin, origin};
    for (std::size_t k = 0; k < element.numbers.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        point.at[i] = combined(point.at[i], builder, element.numbers[k], axes[k][i]);
        point.arm[i] = combined(point.arm[i], builder, element.numbers[k], axes[k][i]);
      }
      point.numbers.push_back(builder.length(element.numbers[k]));
    }
    points.push_back(point);
  }
  return points;
}

ComplexValues values_of(const Pose& pose, int dimension, int axes) {
  ComplexValues values = components(pose.origin, dimension);
  for (int axis = 0; axis < axes; ++axis) {
    const ComplexValues more = components(pose.axes.col(axis), dimension);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

}  // namespace

std::vector<BodyPoint> free_body(SystemBuilder& builder, const RigidBody& body) {
  const int d = builder.dimension();
  const bool has_third = d == 3 && !is_flat(body, d);
  const VectorForm origin = builder.vector();
  std::array<VectorForm, 3> axes;
  axes[0] = builder.vector();
  if (d == 3) axes[1] = builder.vector();
  if (has_third) axes[2] = builder.pseudo_vector();
  const int count = d == 2 ? 1 : (has_third ? 3 : 2);
  builder.define(
      [known = pose_points(body, std::ldexp(1.0, -builder.scene().unit_exponent())), d, count](
          const Placement& at, const ComplexValues&) { return values_of(pose(known, at, d), d, count); });
  builder.add(Equation().plus(axes[0], axes[0]).equals(exactly(1)));
  if (d == 2) {
    axes[1] = {negated(axes[0][1]), axes[0][0], LinearForm{}};
    return placed(builder, body, origin, axes);
  }
  builder.add(Equation().plus(axes[1], axes[1]).equals(exactly(1)));
  builder.add(Equation().plus(axes[0], axes[1]).equals());
  for (std::size_t i = 0; has_third && i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    builder.add(Equation()
                    .plus(axes[0][next], axes[1][last])
                    .minus(axes[0][last], axes[1][next])
                    .minus(axes[2][i])
                    .equals());
  }
  return placed(builder, body, origin, axes);
}

std::vector<BodyPoint> body_at_rest(SystemBuilder& builder, const RigidBody& body) {
  std::vector<BodyPoint> points;
  for (const BodyElement& element : body.elements) {
    BodyPoint point{element.entity, {}};
    for (std::size_t i = 0; i < element.numbers.size(); ++i)
      point.at[i] = constant_form(builder.length(element.numbers[i]));
    points.push_back(point);
  }
  return points;
}

}  // namespace gcs
