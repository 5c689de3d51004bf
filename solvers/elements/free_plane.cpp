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
