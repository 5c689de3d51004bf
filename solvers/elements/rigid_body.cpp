#include <fmt/format.h>

#include <memory>

#include "solvers/elements/body_placing.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/pose_features.hpp"

namespace gcs {
namespace {

/// The axes of the file's coordinates, from its origin or a point of the body.
class FileBasis final : public BodyBasis {
 public:
  FileBasis(const SystemBuilder& builder, const BodyElement* origin)
      : builder_(builder), exponent_(-builder.scene().unit_exponent()) {
    if (origin != nullptr) origin_ = vector(*origin);
  }

  std::vector<ExactNumber> arm(const BodyElement& element) const override {
    std::vector<ExactNumber> numbers;
    if (origin_)
      numbers = exact_numbers(vector(element) - *origin_);
    else
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
    return unit_numbers(vector(to) - vector(from));
  }
  ExactNumber distance(const BodyElement& from, const BodyElement& to) const override {
    return exact_norm(vector(to) - vector(from));
  }
  ExactNumber offset(const BodyElement& plane) const override {
    if (origin_) return offset_from(*origin_, plane, exponent_);
    ExactNumber offset = builder_.length(plane.numbers.back());
    if (!offset.is_zero())
      for (std::size_t k = 0; k < dimension(); ++k)
        offset.divided_by_norm_of.push_back(exact(plane.numbers[k]));
    return offset;
  }

 private:
  std::size_t dimension() const { return static_cast<std::size_t>(builder_.dimension()); }

  RationalVector vector(const BodyElement& element) const {
    return rational_vector(element, 0, builder_.dimension(), exponent_);
  }

  static ExactNumber exact(const Decimal& number) {
    ExactNumber result = exactly(number.value);
    if (number.value != 0) result.decimal = number.text;
    return result;
  }

  const SystemBuilder& builder_;
  int exponent_;
  std::optional<RationalVector> origin_;
};

/// The axes of the frame that given elements leave motions in.
class GivenBasis final : public BodyBasis {
 public:
  explicit GivenBasis(const Scene& scene) : at_(scene) {}

  std::vector<ExactNumber> arm(const BodyElement& element) const override { return at_.place(element); }
  std::vector<ExactNumber> arm_parts(const BodyElement& element) const override { return arm(element); }
  std::vector<ExactNumber> direction(const BodyElement& element, std::size_t) const override {
    return at_.direction(element);
  }
  std::vector<ExactNumber> direction(const BodyElement& from, const BodyElement& to) const override {
    return at_.direction(from, to);
  }
  ExactNumber distance(const BodyElement& from, const BodyElement& to) const override {
    return at_.distance(from, to);
  }
  ExactNumber offset(const BodyElement& plane) const override { return at_.offset(plane); }
  bool has_feet() const override { return true; }

 private:
  GivenCoordinates at_;
};

PlacedBody placed_body(const BodyPlacing& placing, const RigidBody& body,
                       const std::vector<BodyDirection>& directions) {
  PlacedBody placed = placing.run(body);
  for (const BodyDirection& direction : directions)
    placed.directions.push_back(placing.direction(body, direction));
  return placed;
}

/// The axes, after t where the pose has one.
ComplexValues values_of(const BodyPose& pose, int dimension, int axes, bool has_origin) {
  ComplexValues values;
  if (has_origin) values = components(pose.origin, dimension);
  for (int axis = 0; axis < axes; ++axis) {
    const ComplexValues more = components(pose.axes.col(axis), dimension);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

}  // namespace

std::optional<std::string> why_no_pose(const ProblemStatement& problem, const RigidBody& body, int exponent) {
  constexpr double least_area = 1e-9;  // of what the body's vectors span, relative to their lengths
  const PoseFeatures features = pose_features(problem, body, exponent);
  const double lengths =
      features.first.given.norm() * (problem.dimension == 2 ? 1 : features.second.given.norm());
  if (features.from.origin >= 0 && features.area > least_area * lengths) return std::nullopt;
  return fmt::format(
      "the pose of body '{}' is not told by points and planes alone, which is what there are equations for "
      "yet",
      body.name);
}

PlacedBody free_body(SystemBuilder& builder, const RigidBody& body, std::optional<int> joint,
                     const std::vector<BodyDirection>& directions) {
  const int d = builder.dimension();
  const bool has_third = d == 3 && !is_flat(body, d);
  const VectorForm origin = joint ? builder.point(*joint) : builder.vector();
  std::array<VectorForm, 3> axes;
  axes[0] = builder.vector();
  if (d == 3) axes[1] = builder.vector();
  if (has_third) axes[2] = builder.pseudo_vector();
  const int count = d == 2 ? 1 : (has_third ? 3 : 2);
  if (!joint) builder.name({body.name + "_t", origin});
  for (int axis = 0; axis < count; ++axis)
    builder.name({body.name + "_" + "efg"[axis], axes[static_cast<std::size_t>(axis)]});
  const int exponent = -builder.scene().unit_exponent();
  builder.define([features = pose_features(builder.problem(), body, exponent), d, count, joint](
                     const Placement& at, const ComplexValues&) {
    return values_of(body_pose(features, at, d), d, count, !joint);
  });
  builder.add(Equation().plus(axes[0], axes[0]).equals(exactly(1)));
  if (d == 2) axes[1] = {negated(axes[0][1]), axes[0][0], LinearForm{}};
  if (d == 3) {
    builder.add(Equation().plus(axes[1], axes[1]).equals(exactly(1)));
    builder.add(Equation().plus(axes[0], axes[1]).equals());
  }
  for (std::size_t i = 0; has_third && i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    builder.add(Equation()
                    .plus(axes[0][next], axes[1][last])
                    .minus(axes[0][last], axes[1][next])
                    .minus(axes[2][i])
                    .equals());
  }
  const FileBasis basis(builder, joint ? &element_of(body, *joint) : nullptr);
  return placed_body(BodyPlacing(builder, basis, origin, axes), body, directions);
}

PlacedBody body_at_rest(SystemBuilder& builder, const RigidBody& body,
                        const std::vector<BodyDirection>& directions) {
  std::unique_ptr<const BodyBasis> basis;
  if (builder.problem().file_frame && builder.problem().reference_body < 0)
    basis = std::make_unique<GivenBasis>(builder.scene());
  else
    basis = std::make_unique<FileBasis>(builder, nullptr);
  return placed_body(BodyPlacing(builder, *basis, {}, std::nullopt), body, directions);
}

}  // namespace gcs
