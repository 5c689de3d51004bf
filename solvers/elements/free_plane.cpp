#include "solvers/elements/element_kinds.hpp"

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

}  // namespace gcs
