#include "solvers/elements/body_placing.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

/// sum + number·form, for a form whose coefficients are 1 or −1.
LinearForm plus_times(LinearForm sum, const ExactNumber& number, const LinearForm& form) {
  if (number.is_zero()) return sum;
  for (const ScaledUnknown& term : form.terms) {
    ExactNumber coefficient = number;
    if (term.coefficient.is_negative) coefficient = negated(coefficient);
    sum.terms.push_back({term.unknown, coefficient});
  }
  return sum;
}

VectorForm sum_of(VectorForm a, const VectorForm& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    a[i].terms.insert(a[i].terms.end(), b[i].terms.begin(), b[i].terms.end());
    if (a[i].constant.is_zero()) a[i].constant = b[i].constant;
  }
  return a;
}

/// The segments of relations of which a body has both ends, the lower number first.
std::set<std::pair<int, int>> segments_within(const ProblemStatement& problem, const RigidBody& body) {
  std::set<std::pair<int, int>> segments;
  const auto has = [&](int entity) {
    return std::ranges::find(body.elements, entity, &BodyElement::entity) != body.elements.end();
  };
  for (const Relation& relation : problem.relations)
    for (const Operand& of : relation.of)
      if (of.is_segment() && has(of.entity) && has(of.end)) segments.insert(std::minmax(of.entity, of.end));
  return segments;
}

}  // namespace

VectorForm combined(const std::vector<ExactNumber>& numbers, const BodyAxes& axes) {
  VectorForm sum;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      if (axes)
        sum[i] = plus_times(sum[i], numbers[k], (*axes)[k][i]);
      else if (i == k)
        sum[i] = constant_form(numbers[k]);
    }
  return sum;
}

PlacedBody BodyPlacing::run(const RigidBody& body) const {
  PlacedBody placed;
  const ProblemStatement& problem = builder_.problem();
  for (const BodyElement& element : body.elements) {
    if (problem.is_point(element.entity))
      placed.points.push_back(point(element));
    else if (problem.is_line(element.entity))
      placed.lines.push_back({problem.line_of(element.entity), line(element)});
    else
      placed.planes.push_back({problem.plane_of(element.entity), plane(element)});
  }
  for (const auto& [from, to] : segments_within(problem, body))
    placed.segments.push_back({from, to, segment(element_of(body, from), element_of(body, to))});
  return placed;
}

VectorForm BodyPlacing::direction(const RigidBody& body, const BodyDirection& direction) const {
  const ProblemStatement& problem = builder_.problem();
  const BodyElement& from = element_of(body, direction.from);
  const VectorForm known =
      combined(direction.to < 0 ? basis_.direction(from, direction_numbers(problem, direction.from))
                                : basis_.direction(from, element_of(body, direction.to)),
               axes_);
  VectorForm result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_zero(known[i])) continue;
    result[i] = builder_.unknown(builder_.frame().axis(static_cast<int>(i)));
    builder_.define([form = known[i]](const Placement&, const ComplexValues& x) {
      return ComplexValues{value_at(form, x)};
    });
    builder_.add(Equation().plus(result[i]).minus(LinearForm{known[i].terms, {}}).equals(known[i].constant));
  }
  const std::string end = direction.to < 0 ? "" : "_" + problem.name(direction.to);
  builder_.name({problem.name(direction.from) + end + "_u", result});
  return result;
}

BodyPoint BodyPlacing::point(const BodyElement& element) const {
  const VectorForm arm = combined(basis_.arm(element), axes_);
  BodyPoint point{element.entity, sum_of(origin_, arm)};
  if (axes_) {
    point.origin = origin_;
    point.arm = arm;
    point.numbers = basis_.arm_parts(element);
  }
  return point;
}

/// A line at rest that a half-turn of the frame turns over is along the first axis.
LineForms BodyPlacing::line(const BodyElement& element) const {
  const std::size_t first = direction_numbers(builder_.problem(), element.entity);
  return {sum_of(origin_, combined(basis_.arm(element), axes_)),
          combined(basis_.direction(element, first), axes_), axes_ ? 0 : builder_.frame().axis(0),
          basis_.has_feet()};
}

/// h = n·t + k with the offset k from the body's origin t.
PlaneForms BodyPlacing::plane(const BodyElement& element) const {
  PlaneForms plane{combined(basis_.direction(element, 0), axes_), {}, 0};
  const ExactNumber offset = basis_.offset(element);
  if (!axes_) {
    plane.offset = constant_form(offset);
    return plane;
  }
  plane.offset = builder_.unknown(0);
  builder_.define(
      [normal = plane.normal, origin = origin_, offset](const Placement&, const ComplexValues& x) {
        return ComplexValues{bilinear_product(vector_at(normal, x), vector_at(origin, x)) +
                             rounded_to_double(offset)};
      });
  builder_.add(Equation().plus(plane.offset).minus(plane.normal, origin_).equals(offset));
  return plane;
}

SegmentForms BodyPlacing::segment(const BodyElement& from, const BodyElement& to) const {
  return {constant_form(basis_.distance(from, to)), combined(basis_.direction(from, to), axes_), 0};
}

std::size_t direction_numbers(const ProblemStatement& problem, int entity) {
  return problem.is_line(entity) ? static_cast<std::size_t>(problem.dimension) : 0;
}

const BodyElement& element_of(const RigidBody& body, int entity) {
  return *std::ranges::find(body.elements, entity, &BodyElement::entity);
}

}  // namespace gcs
