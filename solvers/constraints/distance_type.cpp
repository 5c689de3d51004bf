#include <algorithm>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/system_builder.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/wide_vector.hpp"

namespace gcs {
namespace {

using enum OperandKind;

ExactNumber given_square(const SystemBuilder& builder, const Relation& relation) {
  return builder.square(relation.given, relation.form == Relation::Form::squared);
}

bool is_constant(const VectorForm& form) {
  return form[0].terms.empty() && form[1].terms.empty() && form[2].terms.empty();
}

/// Σ c_i·u_i for a point c that does not move.
LinearForm along(const VectorForm& point, const VectorForm& direction) {
  LinearForm sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_zero(point[axis])) continue;
    for (ScaledUnknown term : direction[axis].terms) {
      const bool is_negative = term.coefficient.is_negative != point[axis].constant.is_negative;
      term.coefficient = point[axis].constant;
      term.coefficient.is_negative = is_negative;
      sum.terms.push_back(term);
    }
  }
  return sum;
}

/// Whether each of the direction's components is ± an unknown.
bool has_unit_terms(const VectorForm& direction) {
  for (const LinearForm& form : direction) {
    if (!form.constant.is_zero()) return false;
    for (const ScaledUnknown& term : form.terms)
      if (!term.coefficient.decimal.empty() || term.coefficient.value != 1.0) return false;
  }
  return true;
}

/// (p − f)·u, where f·u = 0 if f is the foot.
LinearForm height_along(SystemBuilder& builder, const VectorForm& p, const LineForms& line) {
  if (line.is_foot && std::ranges::all_of(p, [](const LinearForm& form) { return is_zero(form); })) return {};
  if (line.is_foot && is_constant(p) && has_unit_terms(line.direction)) return along(p, line.direction);
  const LinearForm height = builder.unknown(line.turning);
  builder.define([p, line](const Placement&, const ComplexValues& x) {
    return ComplexValues{bilinear_product(Eigen::Vector3cd(vector_at(p, x) - vector_at(line.foot, x)),
                                          vector_at(line.direction, x))};
  });
  Equation equation;
  equation.plus(height).minus(p, line.direction);
  if (!line.is_foot) equation.plus(line.foot, line.direction);
  builder.add(equation.equals());
  return height;
}

/// |c − f|² − w² = a² with w = (c − f)·u.
void state_distance_to_line(SystemBuilder& builder, int point, int line, const ExactNumber& square,
                            int value) {
  const VectorForm& c = builder.point(point);
  const LineForms& l = builder.line(line);
  const LinearForm w = height_along(builder, c, l);
  builder.add(Equation().plus_square_of_difference(c, l.foot).minus(w, w).equals(square), value);
}

void distance_point_line(SystemBuilder& builder, const StatedRelation& stated) {
  state_distance_to_line(builder, stated.entity(0), stated.entity(1), given_square(builder, stated.relation),
                         stated.value);
}

/// |p − q|² where p = t + r with |r| given: t·t + |r|² + 2 t·r − 2 q·t − 2 q·r + q·q, without the squares of r's
/// unknowns.
Equation squared_distance(const BodyPoint& p, const VectorForm& q) {
  const VectorForm twice_q = scaled(q, 1);
  Equation equation;
  equation.plus(p.origin, p.origin).plus(scaled(p.origin, 1), p.arm);
  for (const ExactNumber& number : p.numbers) equation.plus(constant_form(number), constant_form(number));
  return equation.minus(twice_q, p.origin).minus(twice_q, p.arm).plus(q, q);
}

Equation point_distance(const SystemBuilder& builder, int a, int b) {
  if (builder.arm(a) == nullptr) std::swap(a, b);
  if (const BodyPoint* moved = builder.arm(a)) return squared_distance(*moved, builder.point(b));
  return Equation().plus_square_of_difference(builder.point(a), builder.point(b));
}

void distance_point_point(SystemBuilder& builder, const StatedRelation& stated) {
  builder.add(point_distance(builder, stated.entity(0), stated.entity(1))
                  .equals(given_square(builder, stated.relation)),
              stated.value);
}

bool are_parallel(const ProblemStatement& problem, int a, int b) {
  const std::vector<int> parallel = parallel_lines(problem, problem.line_of(a));
  return std::ranges::find(parallel, problem.line_of(b)) != parallel.end();
}

/// n and n·(p − q) of the equations below. In double-double: far away products of nearly isotropic directions cancel.
ComplexValues normal_and_distance(const LineForms& a, const LineForms& b, const ComplexValues& x) {
  const WideVector across =
      cross_product(widened(vector_at(a.direction, x)), widened(vector_at(b.direction, x)));
  const WideVector n = inverse_sqrt(bilinear_product(across, across)) * across;
  ComplexValues result = components(narrowed(n), 3);
  result.push_back(bilinear_product(n, wide_difference(vector_at(a.foot, x), vector_at(b.foot, x))).value());
  return result;
}

/// Of lines that are not parallel the common normal n: n·u = n·v = 0, n·n = 1; then (n·(p − q))² = a².
void distance_line_line(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms &a = builder.line(stated.entity(0)), &b = builder.line(stated.entity(1));
  const ExactNumber square = given_square(builder, stated.relation);
  if (are_parallel(builder.problem(), stated.entity(0), stated.entity(1))) {
    Equation equation;
    equation.plus_square_of_difference(a.foot, b.foot);
    if (!a.is_foot || !b.is_foot) {
      const LinearForm height = height_along(builder, a.foot, b);
      equation.minus(height, height);
    }
    builder.add(equation.equals(square), stated.value);
    return;
  }
  const SignMask turning = builder.new_turning();
  const VectorForm normal = builder.vector(turning);
  const LinearForm apart = builder.unknown(turning);
  builder.define([a, b](const Placement&, const ComplexValues& x) { return normal_and_distance(a, b, x); });
  builder.add(Equation().plus(normal, normal).equals(exactly(1)));
  builder.add(Equation().plus(normal, a.direction).equals());
  builder.add(Equation().plus(normal, b.direction).equals());
  builder.add(Equation().plus(apart).minus(normal, a.foot).plus(normal, b.foot).equals());
  builder.add(Equation().plus(apart, apart).equals(square), stated.value);
}

/// n·p − h = a, as seen from the plane's side.
void distance_point_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const PlaneForms& plane = builder.plane(stated.entity(1));
  builder.add(Equation()
                  .plus(plane.normal, builder.point(stated.entity(0)))
                  .minus(plane.offset)
                  .equals(builder.length(stated.relation.given)),
              stated.value);
}

/// Of a line that is parallel to the plane, (n·p − h)² = a².
void distance_line_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  const PlaneForms& plane = builder.plane(stated.entity(1));
  const LinearForm apart = builder.unknown(plane.turning);
  builder.define([line, plane](const Placement&, const ComplexValues& x) {
    return ComplexValues{bilinear_product(vector_at(plane.normal, x), vector_at(line.foot, x)) -
                         value_at(plane.offset, x)};
  });
  builder.add(Equation().plus(apart).minus(plane.normal, line.foot).plus(plane.offset).equals());
  builder.add(Equation().plus(apart, apart).equals(given_square(builder, stated.relation)), stated.value);
}

bool is_same(const VectorForm& a, const VectorForm& b) {
  const auto unknowns = [](const LinearForm& form) {
    std::vector<int> found;
    for (const ScaledUnknown& term : form.terms) found.push_back(term.unknown);
    return found;
  };
  return std::ranges::equal(a, b, {}, unknowns, unknowns) && !is_constant(a);
}

/// Of parallel planes, as seen from the first: k (n·m) − h = a.
void distance_plane_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const PlaneForms &a = builder.plane(stated.relation.of[0].entity),
                   &b = builder.plane(stated.relation.of[1].entity);
  const ExactNumber length = builder.length(stated.relation.given);
  if (is_same(a.normal, b.normal)) {
    builder.add(Equation().plus(b.offset).minus(a.offset).equals(length), stated.value);
    return;
  }
  const LinearForm sense = builder.unknown(a.turning ^ b.turning);
  builder.define([a, b](const Placement&, const ComplexValues& x) {
    return ComplexValues{bilinear_product(vector_at(a.normal, x), vector_at(b.normal, x))};
  });
  builder.add(Equation().plus(sense).minus(a.normal, b.normal).equals());
  builder.add(Equation().plus(sense, b.offset).minus(a.offset).equals(length), stated.value);
}

}  // namespace

ConstraintType distance_type() {
  using enum ConstraintKind::Joined;
  return {"distance",
          ConstraintType::Value::length,
          {{{point, point}, distance_point_point, {1, 1}},
           {{point, line}, distance_point_line, {1, 2, true}},
           {{point, plane}, distance_point_plane, {1, 1, false, 1}},
           {{line, line}, distance_line_line, {1, 2, true}, in_the_plane},
           {{line, plane}, distance_line_plane, {1, 4}, always},
           {{plane, plane}, distance_plane_plane, {1, 2, true, 0}, always}}};
}

void state_distance(SystemBuilder& builder, int constraint) {
  const ProblemStatement& problem = builder.problem();
  auto [a, b] = problem.constraints[static_cast<std::size_t>(constraint)].between;
  const ExactNumber square = gcs::given_square(builder.scene(), constraint);
  if (!problem.is_point(a)) std::swap(a, b);
  if (problem.is_line(b))
    state_distance_to_line(builder, a, b, square, constraint);
  else if (!builder.is_stated_by_segment(constraint))
    builder.add(point_distance(builder, a, b).equals(square), constraint);
}

}  // namespace gcs
