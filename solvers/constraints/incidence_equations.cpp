#include "solvers/constraints/incidence_equations.hpp"

#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

void state_on_plane(SystemBuilder& builder, const VectorForm& point, const PlaneForms& plane) {
  builder.add(Equation().plus(plane.normal, point).minus(plane.offset).equals());
}

void state_along(SystemBuilder& builder, const Operand& segment, const VectorForm& direction,
                 SignMask turning) {
  const LinearForm length = builder.unknown(turning);
  const VectorForm from = builder.point(segment.entity), to = builder.point(segment.end);
  builder.define([from, to, direction](const Placement&, const ComplexValues& x) {
    return ComplexValues{
        bilinear_product(Eigen::Vector3cd(vector_at(to, x) - vector_at(from, x)), vector_at(direction, x))};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(Equation().plus(to[axis]).minus(from[axis]).minus(length, direction[axis]).equals());
}

void state_across(SystemBuilder& builder, const Operand& segment, const VectorForm& direction) {
  builder.add(Equation()
                  .plus(builder.point(segment.end), direction)
                  .minus(builder.point(segment.entity), direction)
                  .equals());
}

std::vector<int> points_of(const Relation& relation) {
  std::vector<int> points;
  for (const Operand& operand : relation.of) points.push_back(operand.entity);
  return points;
}

}  // namespace gcs
