#include "solvers/elements/element_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

PlaneForms free_plane(SystemBuilder& builder, SignMask turning,
                      const std::function<ComplexPlane(const Placement&)>& where) {
  PlaneForms plane;
  plane.turning = turning;
  plane.normal = builder.vector(turning);
  plane.offset = builder.unknown(turning);
  builder.define([where, d = builder.dimension()](const Placement& at, const ComplexValues&) {
    const ComplexPlane known = where(at);
    ComplexValues values = components(known.normal, d);
    values.push_back(known.offset);
    return values;
  });
  builder.add(Equation().plus(plane.normal, plane.normal).equals(exactly(1)));
  return plane;
}

PlaneForms plane_across(SystemBuilder& builder, const VectorForm& direction, SignMask turning,
                        bool is_either_way, int number) {
  const auto at_number = [number](const Placement& at) {
    return at.planes[static_cast<std::size_t>(number)];
  };
  const auto sense = [direction, at_number](const Placement& at, const ComplexValues& x) {
    return bilinear_product(vector_at(direction, x), at_number(at).normal);
  };
  if (!is_either_way) {
    const PlaneForms plane{direction, builder.unknown(turning), turning};
    builder.define([at_number, sense](const Placement& at, const ComplexValues& x) {
      return ComplexValues{sense(at, x) * at_number(at).offset};
    });
    return plane;
  }
  const SignMask own = builder.turning_of_plane(number);
  const LinearForm opposite = builder.unknown(turning ^ own);
  builder.define(
      [sense](const Placement& at, const ComplexValues& x) { return ComplexValues{sense(at, x)}; });
  const PlaneForms plane{builder.vector(own), builder.unknown(own), own};
  builder.define([at_number](const Placement& at, const ComplexValues&) {
    ComplexValues values = components(at_number(at).normal, 3);
    values.push_back(at_number(at).offset);
    return values;
  });
  builder.add(Equation().plus(opposite, opposite).equals(exactly(1)), gap_value);
  for (std::size_t axis = 0; axis < 3; ++axis)
    builder.add(Equation().plus(plane.normal[axis]).minus(opposite, direction[axis]).equals());
  return plane;
}

PlaneForms further_plane(SystemBuilder& builder, const std::vector<int>& through) {
  return free_plane(builder, builder.new_turning(), [through](const Placement& at) {
    const Eigen::Vector3cd a = at.points.col(through[0]), b = at.points.col(through[1]),
                           c = at.points.col(through[2]);
    const Eigen::Vector3cd normal =
        unit_vector(cross_product(Eigen::Vector3cd(b - a), Eigen::Vector3cd(c - a)));
    return ComplexPlane{normal, bilinear_product(normal, a)};
  });
}

}  // namespace gcs
