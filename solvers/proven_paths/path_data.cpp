#include "solvers/proven_paths/path_data.hpp"

#include <limits>

#include "solvers/numeric/affine_form.hpp"

namespace gcs {
namespace {

using Form = AffineForm<0>;
using Vector = FormVector<0>;

constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;

/// How far a decimal is from its nearest double: half a unit in the last place, which of numbers near
/// underflow is no longer relative to them.
double rounding_of(double nearest) {
  return half_ulp * std::abs(nearest) + std::numeric_limits<double>::denorm_min();
}

Form from_decimal(double nearest) {
  Form form(nearest);
  form.rest = rounding_of(nearest);
  return form;
}

Vector sketched(const Scene& scene, int point) {
  const auto given = scene.problem().sketch->points.col(point);
  Vector result;
  for (int axis = 0; axis < scene.dimension(); ++axis)
    result[axis] = std::ldexp(1.0, -scene.unit_exponent()) * from_decimal(given[axis]);
  return result;
}

/// Not finite where `v` may be zero.
Vector direction(const Vector& v) {
  const Form square_of_length = square(v);
  if (!(square_of_length.low() > 0)) return {Form(std::numeric_limits<double>::quiet_NaN()), {}, {}};
  return reciprocal(sqrt(square_of_length)) * v;
}

/// The axes of Scene::in_frame: the first along the axis point, the second towards the plane point.
std::array<Vector, 3> frame_axes(const Scene& scene, const Vector& origin) {
  const Reference& reference = scene.reference();
  const Vector first = direction(sketched(scene, reference.axis) - origin);
  if (scene.dimension() == 2) return {first, Vector{-first[1], first[0], Form()}, Vector{}};
  if (reference.plane < 0) return {first, Vector{}, Vector{}};
  const Vector to_plane = sketched(scene, reference.plane) - origin;
  const Vector second = direction(to_plane - dot(first, to_plane) * first);
  return {first, second, cross(first, second)};
}

PointBox start_box(const Scene& scene, const DistanceSystem& system) {
  PointBox box{Eigen::VectorXd::Zero(system.unknowns() + 1), Eigen::VectorXd::Zero(system.unknowns() + 1)};
  const Vector origin = sketched(scene, scene.reference().origin);
  const std::array<Vector, 3> axes = frame_axes(scene, origin);
  for (int point = 0; point < system.point_count(); ++point)
    for (int axis = 0; axis < system.dimension(); ++axis)
      if (const int i = system.unknown(point, axis); i >= 0) {
        const Form coordinate = dot(axes[axis], sketched(scene, point) - origin);
        box.mid[i] = coordinate.mid;
        box.radius[i] = coordinate.rest;
      }
  return box;
}

EnclosedLength enclose_length(const Scene& scene, int constraint) {
  const auto [a, b] = scene.problem().constraints[constraint].between;
  const LengthPath& path = scene.length_paths()[constraint];
  const Form of_sketch = sqrt(square(sketched(scene, a) - sketched(scene, b)));
  // A target length is the nearest double of a decimal, or the rounded root of one.
  const double given = scene.problem().constraints[constraint].given.value;
  const double target_error = (half_ulp + rounding_of(given) / given) * path.at_target;
  EnclosedLength length{path,
                        (of_sketch + -path.at_sketch).radius() + std::abs((of_sketch + -path.at_sketch).mid),
                        target_error};
  set_bend_errors(scene, length);
  return length;
}

}  // namespace

bool PathData::is_finite() const {
  bool finite = start.mid.allFinite() && start.radius.allFinite();
  for (const EnclosedLength& length : lengths)
    finite = finite && std::isfinite(length.sketch_error) && std::isfinite(length.target_error);
  return finite;
}

/// A coefficient in the scene's unit is that of the file exactly, but for underflow.
void set_bend_errors(const Scene& scene, EnclosedLength& length) {
  const auto error_of = [&](double coefficient) {
    const double in_file = std::ldexp(coefficient, scene.unit_exponent());
    return coefficient == 0 ? 0 : std::ldexp(rounding_of(in_file), -scene.unit_exponent());
  };
  length.bend_error = error_of(length.path.bend);
  for (const double coefficient : length.path.higher) length.higher_errors.push_back(error_of(coefficient));
}

PathData enclose_path_data(const Scene& scene, const DistanceSystem& system) {
  PathData data;
  data.start = start_box(scene, system);
  for (int i = 0; i < scene.constraint_count(); ++i) data.lengths.push_back(enclose_length(scene, i));
  return data;
}

}  // namespace gcs
