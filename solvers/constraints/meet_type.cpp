#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/system_builder.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using enum OperandKind;

/// f + λ·u = g + μ·v.
void meeting_lines(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms &a = builder.line(stated.entity(0)), &b = builder.line(stated.entity(1));
  const LinearForm lambda = builder.unknown(a.turning), mu = builder.unknown(b.turning);
  builder.define([a, b](const Placement&, const ComplexValues& x) {
    const Eigen::Vector3cd u = vector_at(a.direction, x), v = vector_at(b.direction, x);
    const Eigen::Vector3cd apart = vector_at(b.foot, x) - vector_at(a.foot, x);
    const std::complex<double> c = bilinear_product(u, v), sine = 1.0 - c * c;
    const std::complex<double> along_u = bilinear_product(apart, u), along_v = bilinear_product(apart, v);
    return ComplexValues{(along_u - c * along_v) / sine, (c * along_u - along_v) / sine};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(Equation()
                    .plus(a.foot[axis])
                    .plus(lambda, a.direction[axis])
                    .minus(b.foot[axis])
                    .minus(mu, b.direction[axis])
                    .equals());
}

}  // namespace

ConstraintType meet_type() {
  return {"meet", ConstraintType::Value::none, {{{line, line}, meeting_lines, {1, 1}}}, true};
}

}  // namespace gcs
