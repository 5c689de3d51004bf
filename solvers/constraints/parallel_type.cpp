#include "solvers/constraints/incidence_equations.hpp"
#include "solvers/elements/constraint_types.hpp"

namespace gcs {
namespace {

using enum OperandKind;

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

}  // namespace

/// Lines that share a direction, and planes that share a normal, have it from the start: see place_elements.
ConstraintType parallel_type() {
  using enum ConstraintKind::Joined;
  return {"parallel",
          ConstraintType::Value::none,
          {{{line, line}, state_nothing, {2, 1}, never, true},
           {{line, segment}, parallel_line_segment},
           {{segment, segment}, parallel_segments},
           {{line, plane}, parallel_line_plane, {1, 1}},
           {{plane, segment}, parallel_plane_segment},
           {{plane, plane}, state_nothing, {2, 1}, never, true}}};
}

}  // namespace gcs
