#include "solvers/constraints/incidence_equations.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"

namespace gcs {
namespace {

using enum OperandKind;

void point_on_line(SystemBuilder& builder, const StatedRelation& stated) {
  state_on_line(builder, builder.point(stated.entity(0)), builder.line(stated.entity(1)));
}

void point_on_plane(SystemBuilder& builder, const StatedRelation& stated) {
  state_on_plane(builder, builder.point(stated.entity(0)), builder.plane(stated.entity(1)));
}

void line_on_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  const PlaneForms& plane = builder.plane(stated.entity(1));
  builder.add(Equation().plus(plane.normal, line.direction).equals());
  state_on_plane(builder, line.foot, plane);
}

}  // namespace

ConstraintType on_type() {
  return {"on",
          ConstraintType::Value::none,
          {{{point, line}, point_on_line, {2, 1}},
           {{point, plane}, point_on_plane, {1, 1}},
           {{line, plane}, line_on_plane, {2, 1}}}};
}

}  // namespace gcs
