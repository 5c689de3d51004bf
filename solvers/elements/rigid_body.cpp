#include <fmt/format.h>

#include <Eigen/LU>

#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

/// A vector that moves with a body, from its first point to another one or along a plane's normal.
struct BodyVector {
  Eigen::Vector3cd given;
  int entity = -1;  ///< the other point, or the plane
};

/// What tells the pose of a body: a point, and two vectors that are not parallel.
struct PoseFeatures {
  int origin = -1;
  Eigen::Vector3cd origin_given = Eigen::Vector3cd::Zero();
  BodyVector first, second;
  double area = 0;  ///< of the two vectors
};

std::vector<BodyVector> body_vectors(const ProblemStatement& problem, const RigidBody& body, int exponent,
                                     PoseFeatures& features) {
  std::vector<BodyVector> vectors, normals;
  for (const BodyElement& element : body.elements) {
    const ElementPosition position = position_in_body(problem, element, exponent);
    if (const auto* plane = std::get_if<PlanePosition>(&position))
      normals.push_back({plane->normal.cast<std::complex<double>>(), element.entity});
    const auto* point = std::get_if<Eigen::Vector3d>(&position);
    if (point == nullptr) continue;
    const Eigen::Vector3cd at = point->cast<std::complex<double>>();
    if (features.origin < 0) {
      features.origin = element.entity;
      features.origin_given = at;
    } else {
      vectors.push_back({at - features.origin_given, element.entity});
    }
  }
  vectors.insert(vectors.end(), normals.begin(), normals.end());
  return vectors;
}

/// Columns: a vector, another one and their vector product; in the plane the second is the first turned by a right
/// angle.
Eigen::Matrix3cd triad(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, int dimension) {
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  const Eigen::Vector3cd second = dimension == 2 ? cross_product(up, a) : b;
  Eigen::Matrix3cd result;
  result << a, second, cross_product(a, second);
  return result;
}

/// Of all pairs of vectors the one of largest area; in the plane one vector is enough.
PoseFeatures pose_features(const ProblemStatement& problem, const RigidBody& body, int exponent) {
  PoseFeatures features;
  const std::vector<BodyVector> vectors = body_vectors(problem, body, exponent, features);
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  for (const BodyVector& a : vectors)
    for (const BodyVector& b : vectors) {
      const double area = cross_product(a.given, problem.dimension == 2 ? up : b.given).norm();
      if (!(area > features.area)) continue;
      features.area = area;
      features.first = a;
      features.second = b;
    }
  return features;
}

/// t, then the images of the axes.
struct Pose {
  Eigen::Vector3cd origin;
  Eigen::Matrix3cd axes;
};

Pose pose(const PoseFeatures& body, const Placement& placement, int dimension) {
  const auto points = placement.points.cols();
  const auto lines = static_cast<Eigen::Index>(placement.lines.size());
  const Eigen::Vector3cd origin = placement.points.col(body.origin);
  const auto moved = [&](const BodyVector& vector) -> Eigen::Vector3cd {
    if (vector.entity < points) return placement.points.col(vector.entity) - origin;
    return placement.planes[static_cast<std::size_t>(vector.entity - points - lines)].normal;
  };
  const Eigen::Matrix3cd axes = triad(moved(body.first), moved(body.second), dimension) *
                                triad(body.first.given, body.second.given, dimension).inverse();
  return {origin - axes * body.origin_given, axes};
}

/// sum + number·form, for a form whose coefficients are 1 or −1.
LinearForm plus_times(LinearForm sum, const ExactNumber& number, const LinearForm& form) {
  if (number.is_zero()) return sum;
  for (const ScaledUnknown& term : form.terms) {
    ExactNumber coefficient = number;
    if (term.coefficient.is_negative) coefficient = negated(coefficient);
    sum.terms.push_back({term.unknown, coefficient});
  }
  return sum;
}

/// Σ number_k·axis_k; the axes of a body at rest are those of the frame.
VectorForm combined(const std::vector<ExactNumber>& numbers,
                    const std::optional<std::array<VectorForm, 3>>& axes) {
  VectorForm sum;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      if (axes)
        sum[i] = plus_times(sum[i], numbers[k], (*axes)[k][i]);
      else if (i == k)
        sum[i] = constant_form(numbers[k]);
    }
  return sum;
}

VectorForm sum_of(VectorForm a, const VectorForm& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    a[i].terms.insert(a[i].terms.end(), b[i].terms.begin(), b[i].terms.end());
    if (a[i].constant.is_zero()) a[i].constant = b[i].constant;
  }
  return a;
}

/// Puts the elements of a body where its pose does.
class BodyPlacing {
 public:
  /// `axes`: none for a body at rest, whose origin is 0.
  BodyPlacing(SystemBuilder& builder, VectorForm origin, std::optional<std::array<VectorForm, 3>> axes)
      : builder_(builder), origin_(std::move(origin)), axes_(std::move(axes)) {}

  PlacedBody run(const RigidBody& body) {
    for (const BodyElement& element : body.elements) {
      const ProblemStatement& problem = builder_.problem();
      if (problem.is_point(element.entity))
        place_point(element);
      else if (problem.is_line(element.entity))
        placed_.lines.push_back({problem.line_of(element.entity), line(element)});
      else
        placed_.planes.push_back({problem.plane_of(element.entity), plane(element)});
    }
    return std::move(placed_);
  }

 private:
  std::size_t dimension() const { return static_cast<std::size_t>(builder_.dimension()); }

  std::vector<ExactNumber> lengths(const BodyElement& element) const {
    std::vector<ExactNumber> numbers;
    for (std::size_t k = 0; k < dimension(); ++k) numbers.push_back(builder_.length(element.numbers[k]));
    return numbers;
  }

  static ExactNumber exact(const Decimal& number) {
    ExactNumber result = exactly(number.value);
    if (number.value != 0) result.decimal = number.text;
    return result;
  }

  /// A direction of length 1, from the numbers that begin at `from`.
  std::vector<ExactNumber> unit(const BodyElement& element, std::size_t from) const {
    std::vector<ExactNumber> numbers;
    for (std::size_t k = 0; k < dimension(); ++k) numbers.push_back(exact(element.numbers[from + k]));
    std::vector<ExactNumber> result = numbers;
    for (ExactNumber& number : result)
      if (!number.is_zero()) number.divided_by_norm_of = numbers;
    return result;
  }

  void place_point(const BodyElement& element) {
    const std::vector<ExactNumber> numbers = lengths(element);
    const VectorForm arm = combined(numbers, axes_);
    BodyPoint point{element.entity, sum_of(origin_, arm)};
    if (axes_) {
      point.origin = origin_;
      point.arm = arm;
      point.numbers = numbers;
    }
    placed_.points.push_back(point);
  }

  LineForms line(const BodyElement& element) const {
    return {sum_of(origin_, combined(lengths(element), axes_)), combined(unit(element, dimension()), axes_),
            0, false};
  }

  /// h = n·t + k with the body's own offset k.
  PlaneForms plane(const BodyElement& element) {
    PlaneForms plane{combined(unit(element, 0), axes_), {}, 0};
    ExactNumber offset = builder_.length(element.numbers.back());
    if (!offset.is_zero())
      for (std::size_t k = 0; k < dimension(); ++k)
        offset.divided_by_norm_of.push_back(exact(element.numbers[k]));
    if (!axes_) {
      plane.offset = constant_form(offset);
      return plane;
    }
    plane.offset = builder_.unknown(0);
    builder_.define(
        [normal = plane.normal, origin = origin_, offset](const Placement&, const ComplexValues& x) {
          return ComplexValues{bilinear_product(vector_at(normal, x), vector_at(origin, x)) +
                               rounded_to_double(offset)};
        });
    builder_.add(Equation().plus(plane.offset).minus(plane.normal, origin_).equals(offset));
    return plane;
  }

  SystemBuilder& builder_;
  VectorForm origin_;
  std::optional<std::array<VectorForm, 3>> axes_;
  PlacedBody placed_;
};

ComplexValues values_of(const Pose& pose, int dimension, int axes) {
  ComplexValues values = components(pose.origin, dimension);
  for (int axis = 0; axis < axes; ++axis) {
    const ComplexValues more = components(pose.axes.col(axis), dimension);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

}  // namespace

std::optional<std::string> why_no_pose(const ProblemStatement& problem, const RigidBody& body) {
  constexpr double least_area = 1e-9;  // of what the body's vectors span, relative to their lengths
  const PoseFeatures features = pose_features(problem, body, 0);
  const double lengths =
      features.first.given.norm() * (problem.dimension == 2 ? 1 : features.second.given.norm());
  if (features.origin >= 0 && features.area > least_area * lengths) return std::nullopt;
  return fmt::format(
      "the pose of body '{}' is not told by points and planes alone, which is what there are equations for "
      "yet",
      body.name);
}

PlacedBody free_body(SystemBuilder& builder, const RigidBody& body) {
  const int d = builder.dimension();
  const bool has_third = d == 3 && !is_flat(body, d);
  const VectorForm origin = builder.vector();
  std::array<VectorForm, 3> axes;
  axes[0] = builder.vector();
  if (d == 3) axes[1] = builder.vector();
  if (has_third) axes[2] = builder.pseudo_vector();
  const int count = d == 2 ? 1 : (has_third ? 3 : 2);
  const int exponent = -builder.scene().unit_exponent();
  builder.define(
      [features = pose_features(builder.problem(), body, exponent), d, count](
          const Placement& at, const ComplexValues&) { return values_of(pose(features, at, d), d, count); });
  builder.add(Equation().plus(axes[0], axes[0]).equals(exactly(1)));
  if (d == 2) {
    axes[1] = {negated(axes[0][1]), axes[0][0], LinearForm{}};
    return BodyPlacing(builder, origin, axes).run(body);
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
  return BodyPlacing(builder, origin, axes).run(body);
}

PlacedBody body_at_rest(SystemBuilder& builder, const RigidBody& body) {
  return BodyPlacing(builder, {}, std::nullopt).run(body);
}

}  // namespace gcs
