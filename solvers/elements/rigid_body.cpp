#include <fmt/format.h>

#include <Eigen/LU>

#include "solvers/elements/body_placing.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/elements/pose_features.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

/// What tells the pose of a body: a point, and two vectors that are not parallel.
struct PoseFeatures {
  BodyVectors from;
  BodyVector first, second;
  double area = 0;  ///< of the two vectors
};

/// In the plane the second vector is the first turned by a right angle.
Eigen::Vector3cd second_vector(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, int dimension) {
  const Eigen::Vector3cd up = Eigen::Vector3cd::UnitZ();
  return dimension == 2 ? cross_product(up, a) : b;
}

/// Of all pairs of vectors the one of largest area; in the plane one vector is enough.
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

/// t, then the images of the axes.
struct Pose {
  Eigen::Vector3cd origin;
  Eigen::Matrix3cd axes;
};

Pose pose(const PoseFeatures& body, const Placement& placement, int dimension) {
  const auto triad_of = [dimension](const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
    return triad(a, second_vector(a, b, dimension));
  };
  const int from = body.from.origin;
  const Eigen::Matrix3cd axes =
      triad_of(moved_vector(body.first, from, placement), moved_vector(body.second, from, placement)) *
      triad_of(body.first.given, body.second.given).inverse();
  return {placement.points.col(from) - axes * body.from.origin_given, axes};
}

/// The axes of the file's coordinates.
class FileBasis final : public BodyBasis {
 public:
  explicit FileBasis(const SystemBuilder& builder) : builder_(builder) {}

  std::vector<ExactNumber> arm(const BodyElement& element) const override {
    std::vector<ExactNumber> numbers;
    for (std::size_t k = 0; k < dimension(); ++k) numbers.push_back(builder_.length(element.numbers[k]));
    return numbers;
  }
  std::vector<ExactNumber> arm_parts(const BodyElement& element) const override { return arm(element); }
  std::vector<ExactNumber> direction(const BodyElement& element, std::size_t first) const override {
    std::vector<ExactNumber> numbers;
    for (std::size_t k = 0; k < dimension(); ++k) numbers.push_back(exact(element.numbers[first + k]));
    std::vector<ExactNumber> result = numbers;
    for (ExactNumber& number : result)
      if (!number.is_zero()) number.divided_by_norm_of = numbers;
    return result;
  }
  std::vector<ExactNumber> direction(const BodyElement& from, const BodyElement& to) const override {
    const int exponent = -builder_.scene().unit_exponent();
    return unit_numbers(rational_vector(to, 0, exponent) - rational_vector(from, 0, exponent));
  }
  ExactNumber offset(const BodyElement& plane) const override {
    ExactNumber offset = builder_.length(plane.numbers.back());
    if (!offset.is_zero())
      for (std::size_t k = 0; k < dimension(); ++k)
        offset.divided_by_norm_of.push_back(exact(plane.numbers[k]));
    return offset;
  }

 private:
  std::size_t dimension() const { return static_cast<std::size_t>(builder_.dimension()); }

  static ExactNumber exact(const Decimal& number) {
    ExactNumber result = exactly(number.value);
    if (number.value != 0) result.decimal = number.text;
    return result;
  }

  const SystemBuilder& builder_;
};

PlacedBody placed_body(SystemBuilder& builder, const RigidBody& body, VectorForm origin, BodyAxes axes,
                       const std::vector<BodyDirection>& directions) {
  const FileBasis basis(builder);
  const BodyPlacing placing(builder, basis, std::move(origin), std::move(axes));
  PlacedBody placed = placing.run(body);
  for (const BodyDirection& direction : directions)
    placed.directions.push_back(placing.direction(body, direction.from, direction.to));
  return placed;
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

std::optional<std::string> why_no_pose(const ProblemStatement& problem, const RigidBody& body) {
  constexpr double least_area = 1e-9;  // of what the body's vectors span, relative to their lengths
  const PoseFeatures features = pose_features(problem, body, 0);
  const double lengths =
      features.first.given.norm() * (problem.dimension == 2 ? 1 : features.second.given.norm());
  if (features.from.origin >= 0 && features.area > least_area * lengths) return std::nullopt;
  return fmt::format(
      "the pose of body '{}' is not told by points and planes alone, which is what there are equations for "
      "yet",
      body.name);
}

PlacedBody free_body(SystemBuilder& builder, const RigidBody& body,
                     const std::vector<BodyDirection>& directions) {
  const int d = builder.dimension();
  const bool has_third = d == 3 && !is_flat(body, d);
  const VectorForm origin = builder.vector();
  std::array<VectorForm, 3> axes;
  axes[0] = builder.vector();
  if (d == 3) axes[1] = builder.vector();
  if (has_third) axes[2] = builder.pseudo_vector();
  const int count = d == 2 ? 1 : (has_third ? 3 : 2);
  builder.name({body.name + "_t", origin});
  for (int axis = 0; axis < count; ++axis)
    builder.name({body.name + "_" + "efg"[axis], axes[static_cast<std::size_t>(axis)]});
  const int exponent = -builder.scene().unit_exponent();
  builder.define(
      [features = pose_features(builder.problem(), body, exponent), d, count](
          const Placement& at, const ComplexValues&) { return values_of(pose(features, at, d), d, count); });
  builder.add(Equation().plus(axes[0], axes[0]).equals(exactly(1)));
  if (d == 2) {
    axes[1] = {negated(axes[0][1]), axes[0][0], LinearForm{}};
    return placed_body(builder, body, origin, axes, directions);
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
  return placed_body(builder, body, origin, axes, directions);
}

PlacedBody body_at_rest(SystemBuilder& builder, const RigidBody& body,
                        const std::vector<BodyDirection>& directions) {
  return placed_body(builder, body, {}, std::nullopt, directions);
}

}  // namespace gcs
