#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/system_builder.hpp"
#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

using enum OperandKind;

/// An unknown that is the bilinear product of two vectors, its sign turned with each of them.
LinearForm product_unknown(SystemBuilder& builder, const VectorForm& left, const VectorForm& right,
                           SignMask turning) {
  const LinearForm product = builder.unknown(turning);
  builder.define([left, right](const Placement&, const ComplexValues& x) {
    std::complex<double> sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += value_at(left[axis], x) * value_at(right[axis], x);
    return ComplexValues{sum};
  });
  builder.add(Equation().plus(product).minus(left, right).equals());
  return product;
}

/// s² = cos² with s = u·v: both signs are one angle.
void between_directions(SystemBuilder& builder, const VectorForm& u, const VectorForm& v, SignMask turning,
                        const StatedRelation& stated) {
  const LinearForm cosine = product_unknown(builder, u, v, turning);
  builder.add(Equation().plus(cosine, cosine).equals(given_cosine(stated.relation, true)), stated.value);
}

/// 1 − s² = cos² with s = n·u.
void with_plane(SystemBuilder& builder, const VectorForm& u, SignMask turning, const PlaneForms& plane,
                const StatedRelation& stated) {
  const LinearForm sine = product_unknown(builder, plane.normal, u, plane.turning ^ turning);
  builder.add(Equation()
                  .plus(constant_form(exactly(1)))
                  .minus(sine, sine)
                  .equals(given_cosine(stated.relation, true)),
              stated.value);
}

void angle_line_line(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms &a = builder.line(stated.entity(0)), &b = builder.line(stated.entity(1));
  between_directions(builder, a.direction, b.direction, a.turning ^ b.turning, stated);
}

void angle_line_segment(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  const SegmentForms segment = builder.segment(stated.of(1));
  between_directions(builder, line.direction, segment.direction, line.turning ^ segment.turning, stated);
}

void angle_line_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  with_plane(builder, line.direction, line.turning, builder.plane(stated.entity(1)), stated);
}

void angle_plane_segment(SystemBuilder& builder, const StatedRelation& stated) {
  const SegmentForms segment = builder.segment(stated.of(1));
  with_plane(builder, segment.direction, segment.turning, builder.plane(stated.entity(0)), stated);
}

void angle_plane_plane(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(Equation()
                  .plus(builder.plane(stated.entity(0)).normal, builder.plane(stated.entity(1)).normal)
                  .equals(given_cosine(stated.relation, false)),
              stated.value);
}

void angle_segment_segment(SystemBuilder& builder, const StatedRelation& stated) {
  const SegmentForms a = builder.segment(stated.of(0)), b = builder.segment(stated.of(1));
  builder.add(Equation().plus(a.direction, b.direction).equals(given_cosine(stated.relation, false)),
              stated.value);
}

}  // namespace

ConstraintType angle_type() {
  return {"angle",
          ConstraintType::Value::angle,
          {{{line, line}, angle_line_line, {1, 2}},
           {{line, segment}, angle_line_segment},
           {{segment, segment}, angle_segment_segment},
           {{line, plane}, angle_line_plane, {1, 2}},
           {{plane, segment}, angle_plane_segment},
           {{plane, plane}, angle_plane_plane, {1, 1}}}};
}

}  // namespace gcs
