#include "solvers/constraints/incidence_equations.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"

namespace gcs {
namespace {

void coplanar(SystemBuilder& builder, const StatedRelation& stated) {
  const std::vector<int> points = points_of(stated.relation);
  const PlaneForms plane = further_plane(builder, points);
  for (const int point : points) state_on_plane(builder, builder.point(point), plane);
}

}  // namespace

ConstraintType coplanar_type() {
  return {"coplanar", ConstraintType::Value::none, {{{}, coplanar}}, true, 4};
}

}  // namespace gcs
