#include <array>

#include "solvers/elements/constraint_kinds.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using enum OperandKind;

void incidence_point_line(SystemBuilder& builder, const StatedRelation& stated) {
  state_on_line(builder, builder.point(stated.entity(0)), builder.line(stated.entity(1)));
}

void incidence_point_plane(SystemBuilder& builder, const StatedRelation& stated) {
  state_on_plane(builder, builder.point(stated.entity(0)), builder.plane(stated.entity(1)));
}

void incidence_line_plane(SystemBuilder& builder, const StatedRelation& stated) {
  const LineForms& line = builder.line(stated.entity(0));
  const PlaneForms& plane = builder.plane(stated.entity(1));
  builder.add(Equation().plus(plane.normal, line.direction).equals());
  state_on_plane(builder, line.foot, plane);
}

/// f + λ·u = g + μ·v.
void incidence_line_line(SystemBuilder& builder, const StatedRelation& stated) {
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

std::vector<int> points_of(const StatedRelation& stated) {
  std::vector<int> points;
  for (const Operand& operand : stated.relation.of) points.push_back(operand.entity);
  return points;
}

/// A further line carries the points, so that nothing but collinear points fits.
void collinear(SystemBuilder& builder, const StatedRelation& stated) {
  const std::vector<int> points = points_of(stated);
  const LineForms line = further_line(builder, points);
  for (const int point : points) state_on_line(builder, builder.point(point), line);
}

void coplanar(SystemBuilder& builder, const StatedRelation& stated) {
  const std::vector<int> points = points_of(stated);
  const PlaneForms plane = further_plane(builder, points);
  for (const int point : points) state_on_plane(builder, builder.point(point), plane);
}

}  // namespace

std::span<const ConstraintKind> incidence_kinds() {
  static constexpr std::array rows{ConstraintKind{RelationType::on, {{point, line}}, incidence_point_line},
                                   ConstraintKind{RelationType::on, {{point, plane}}, incidence_point_plane},
                                   ConstraintKind{RelationType::on, {{line, plane}}, incidence_line_plane},
                                   ConstraintKind{RelationType::meet, {{line, line}}, incidence_line_line},
                                   ConstraintKind{RelationType::collinear, std::nullopt, collinear},
                                   ConstraintKind{RelationType::coplanar, std::nullopt, coplanar}};
  return rows;
}

void state_on_line(SystemBuilder& builder, const VectorForm& point, const LineForms& line) {
  const LinearForm along = builder.unknown(line.turning);
  builder.define([point, line](const Placement&, const ComplexValues& x) {
    const Eigen::Vector3cd way = vector_at(point, x) - vector_at(line.foot, x);
    return ComplexValues{bilinear_product(way, vector_at(line.direction, x))};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(
        Equation().plus(line.foot[axis]).plus(along, line.direction[axis]).minus(point[axis]).equals());
}

void state_on_plane(SystemBuilder& builder, const VectorForm& point, const PlaneForms& plane) {
  builder.add(Equation().plus(plane.normal, point).minus(plane.offset).equals());
}

}  // namespace gcs
