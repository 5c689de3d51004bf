#include "solvers/constraints/incidence_equations.hpp"
#include "solvers/elements/constraint_types.hpp"

namespace gcs {
namespace {

using enum OperandKind;

void perpendicular_lines(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(Equation()
                  .plus(builder.line(stated.entity(0)).direction, builder.line(stated.entity(1)).direction)
                  .equals());
}

void perpendicular_line_segment(SystemBuilder& builder, const StatedRelation& stated) {
  state_across(builder, stated.of(1), builder.line(stated.entity(0)).direction);
}

void perpendicular_segments(SystemBuilder& builder, const StatedRelation& stated) {
  const VectorForm &a = builder.point(stated.of(0).entity), &b = builder.point(stated.of(0).end),
                   &c = builder.point(stated.of(1).entity), &d = builder.point(stated.of(1).end);
  builder.add(Equation().plus(b, d).minus(b, c).minus(a, d).plus(a, c).equals());
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

}  // namespace

/// A line that is perpendicular to a plane has its normal from the start: see place_lines.
ConstraintType perpendicular_type() {
  using enum ConstraintKind::Joined;
  return {"perpendicular",
          ConstraintType::Value::none,
          {{{line, line}, perpendicular_lines, {1, 1}},
           {{line, segment}, perpendicular_line_segment},
           {{segment, segment}, perpendicular_segments},
           {{line, plane}, state_nothing, {2, 1}, never, true},
           {{plane, segment}, perpendicular_plane_segment},
           {{plane, plane}, perpendicular_planes, {1, 1}}}};
}

}  // namespace gcs
