#include <array>

#include "solvers/elements/constraint_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using enum OperandKind;

VectorForm start(SystemBuilder& builder, const Operand& segment) { return builder.point(segment.entity); }
VectorForm end(SystemBuilder& builder, const Operand& segment) { return builder.point(segment.end); }

/// (end − start)·direction = 0
void state_across(SystemBuilder& builder, const Operand& segment, const VectorForm& direction) {
  builder.add(
      Equation().plus(end(builder, segment), direction).minus(start(builder, segment), direction).equals());
}

/// Elements that share a direction have it from the start: see place_lines.
void shared_direction(SystemBuilder&, const StatedRelation&) {}

void parallel_line_segment(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  state_along(builder, stated.of(1), line.direction, line.turning);
}

void parallel_segments(SystemBuilder& builder, const StatedRelation& stated) {
  const SegmentForms first = builder.segment(stated.of(0));
  state_along(builder, stated.of(1), first.direction, first.turning);
}

void parallel_line_plane(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(Equation()
                  .plus(builder.line(stated.entity(0)).direction, builder.plane(stated.entity(1)).normal)
                  .equals());
}

void parallel_plane_segment(SystemBuilder& builder, const StatedRelation& stated) {
  state_across(builder, stated.of(1), builder.plane(stated.entity(0)).normal);
}

void perpendicular_lines(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(Equation()
                  .plus(builder.line(stated.entity(0)).direction, builder.line(stated.entity(1)).direction)
                  .equals());
}

void perpendicular_line_segment(SystemBuilder& builder, const StatedRelation& stated) {
  state_across(builder, stated.of(1), builder.line(stated.entity(0)).direction);
}

void perpendicular_segments(SystemBuilder& builder, const StatedRelation& stated) {
  const Operand &a = stated.of(0), &b = stated.of(1);
  builder.add(Equation()
                  .plus(end(builder, a), end(builder, b))
                  .minus(end(builder, a), start(builder, b))
                  .minus(start(builder, a), end(builder, b))
                  .plus(start(builder, a), start(builder, b))
                  .equals());
}

void perpendicular_planes(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(Equation()
                  .plus(builder.plane(stated.entity(0)).normal, builder.plane(stated.entity(1)).normal)
                  .equals());
}

void perpendicular_plane_segment(SystemBuilder& builder, const StatedRelation& stated) {
  const PlaneForms& plane = builder.plane(stated.entity(0));
  state_along(builder, stated.of(1), plane.normal, plane.turning);
}

void orientation(SystemBuilder&, const StatedRelation&) {}

}  // namespace

std::span<const ConstraintKind> direction_kinds() {
  static constexpr std::array rows{
      ConstraintKind{RelationType::parallel, {{line, line}}, shared_direction},
      ConstraintKind{RelationType::parallel, {{line, segment}}, parallel_line_segment},
      ConstraintKind{RelationType::parallel, {{segment, segment}}, parallel_segments},
      ConstraintKind{RelationType::parallel, {{line, plane}}, parallel_line_plane},
      ConstraintKind{RelationType::parallel, {{plane, segment}}, parallel_plane_segment},
      ConstraintKind{RelationType::perpendicular, {{line, line}}, perpendicular_lines},
      ConstraintKind{RelationType::perpendicular, {{line, segment}}, perpendicular_line_segment},
      ConstraintKind{RelationType::perpendicular, {{segment, segment}}, perpendicular_segments},
      ConstraintKind{RelationType::perpendicular, {{plane, plane}}, perpendicular_planes},
      ConstraintKind{RelationType::perpendicular, {{line, plane}}, shared_direction},
      ConstraintKind{RelationType::perpendicular, {{plane, segment}}, perpendicular_plane_segment},
      ConstraintKind{RelationType::orientation, std::nullopt, orientation}};
  return rows;
}

void state_along(SystemBuilder& builder, const Operand& segment, const VectorForm& direction,
                 SignMask turning) {
  const LinearForm length = builder.unknown(turning);
  const VectorForm from = start(builder, segment), to = end(builder, segment);
  builder.define([from, to, direction](const Placement&, const ComplexValues& x) {
    return ComplexValues{
        bilinear_product(Eigen::Vector3cd(vector_at(to, x) - vector_at(from, x)), vector_at(direction, x))};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(Equation().plus(to[axis]).minus(from[axis]).minus(length, direction[axis]).equals());
}

}  // namespace gcs
