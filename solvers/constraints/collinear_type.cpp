#include "solvers/constraints/incidence_equations.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"

namespace gcs {
namespace {

/// A further line carries the points, so that nothing but collinear points fits.
void collinear(SystemBuilder& builder, const StatedRelation& stated) {
  const std::vector<int> points = points_of(stated.relation);
  const LineForms line = further_line(builder, points);
  for (const int point : points) state_on_line(builder, builder.point(point), line);
}

}  // namespace

ConstraintType collinear_type() {
  return {"collinear", ConstraintType::Value::none, {{{}, collinear}}, false, 3};
}

}  // namespace gcs
