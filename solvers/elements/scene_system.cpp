#include "solvers/elements/scene_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/elements/body_order.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/scene_elements.hpp"
#include "solvers/elements/stated_signs.hpp"

namespace gcs {
namespace {

constexpr std::size_t most_turnings = 56;

std::optional<std::string> why_no_bodies(const Scene& scene) {
  const ProblemStatement problem = with_given_body(scene.problem());
  for (const RigidBody& body : scene.problem().bodies)
    if (auto reason = why_no_pose(problem, body, -scene.unit_exponent())) return reason;
  std::string reason = body_order(problem).reason;
  return reason.empty() ? std::nullopt : std::optional(std::move(reason));
}

std::optional<std::string> why_no_relation(const ProblemStatement& problem) {
  for (Relation relation : problem.relations) {
    const ConstraintKind* kind = find_kind(problem, relation);
    if (kind == nullptr || kind->state == nullptr)
      return fmt::format("there are no equations yet for constraint '{}'", relation.id);
  }
  return std::nullopt;
}

/// At most so much changes a form when each unknown changes by its offset.
double shift_of(const LinearForm& form, const std::vector<double>& offsets) {
  double sum = 0;
  for (const ScaledUnknown& term : form.terms)
    sum += std::abs(rounded_to_double(term.coefficient)) * offsets[static_cast<std::size_t>(term.unknown)];
  return sum * (1 + 16 * std::numeric_limits<double>::epsilon());
}

bool changes_with(const LinearForm& form, const Eigen::MatrixXcd& changes) {
  constexpr double tolerance = 1e-7;  // of directions of length 1
  Eigen::RowVectorXcd sum = Eigen::RowVectorXcd::Zero(changes.cols());
  for (const ScaledUnknown& term : form.terms)
    sum += rounded_to_double(term.coefficient) * changes.row(term.unknown);
  return sum.norm() > tolerance;
}

template <class Condition>
std::vector<int> equations_where(const std::vector<int>& value_of, const Condition& condition) {
  std::vector<int> result;
  for (std::size_t e = 0; e < value_of.size(); ++e)
    if (condition(value_of[e])) result.push_back(static_cast<int>(e));
  return result;
}

void state_all(SystemBuilder& builder) {
  const ProblemStatement& problem = builder.problem();
  int value = builder.scene().constraint_count();
  for (Relation relation : problem.relations) {
    const ConstraintKind* kind = find_kind(problem, relation);
    builder.begin(value);
    kind->state(builder, {relation, value++});
  }
  for (int i = 0; i < builder.scene().constraint_count(); ++i) {
    builder.begin(i);
    state_distance(builder, i);
  }
}

}  // namespace

std::optional<std::string> why_no_system(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (auto reason = why_no_frame(scene)) return reason;
  if (auto reason = why_no_bodies(scene)) return reason;
  if (auto reason = why_no_relation(problem)) return reason;
  const auto turned = static_cast<std::size_t>(
      std::ranges::count_if(problem.relations, [](const Relation& r) { return r.sign == 0; }));
  if (problem.lines.size() + problem.planes.size() + 2 * turned > most_turnings)
    return fmt::format("there are more than {} lines, planes and constraints that may be turned over",
                       most_turnings);
  return std::nullopt;
}

std::vector<int> SceneSystem::without_value() const {
  return equations_where(value_of(), [](int value) { return value < 0; });
}

std::vector<int> SceneSystem::of_parts() const {
  return equations_where(value_of(), [](int value) { return value == no_value; });
}

bool SceneSystem::moves(int entity, const Eigen::MatrixXcd& changes) const {
  const ProblemStatement& problem = builder_.problem();
  std::vector<VectorForm> forms;
  if (problem.is_point(entity)) {
    forms = {builder_.point(entity)};
  } else if (problem.is_line(entity)) {
    forms = {builder_.line(entity).foot, builder_.line(entity).direction};
  } else {
    const PlaneForms& plane = builder_.plane(entity);
    forms = {plane.normal, {plane.offset}};
  }
  return std::ranges::any_of(forms, [&](const VectorForm& form) {
    return std::ranges::any_of(form,
                               [&](const LinearForm& component) { return changes_with(component, changes); });
  });
}

SceneSystem::SceneSystem(const Scene& scene) : builder_(scene) {
  place_elements(builder_);
  state_all(builder_);
}

ComplexValues SceneSystem::coordinates(const Figure& figure) const {
  Placement placement = placement_of(figure);
  placement.turned_segments = turned_segments(builder_.problem(), placement.points);
  return builder_.values(placement);
}

ComplexValues SceneSystem::coordinates_as_drawn(const Figure& figure) const {
  return builder_.values(placement_of(figure));
}

double SceneSystem::misfit(const Figure& figure) const {
  const ComplexValues x = coordinates(figure);
  return farthest(figure, x, std::vector<double>(x.size(), 0), 0);
}

double SceneSystem::distance(const Figure& figure, const ComplexValues& x,
                             const std::vector<double>& offsets) const {
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  return farthest(figure, x, offsets, rounding) * (1 + rounding);
}

double SceneSystem::farthest(const Figure& figure, const ComplexValues& x, const std::vector<double>& offsets,
                             double rounding) const {
  const ProblemStatement& problem = builder_.problem();
  const Placement at = placement_of(figure), at_x = builder_.placement(x);
  const auto apart = [rounding](const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
    return (a - b).norm() + rounding * (a.norm() + b.norm());
  };
  const auto shift = [&](const VectorForm& forms) {
    return std::hypot(shift_of(forms[0], offsets), shift_of(forms[1], offsets), shift_of(forms[2], offsets));
  };
  // The point nearest to the origin, f − (f·u) u, of a line that is given by another one.
  const auto foot_shift = [&](const LineForms& forms, const ComplexLine& line) {
    const double reach = vector_at(forms.foot, x).norm() + line.point.norm();
    return forms.is_foot ? shift(forms.foot) : 3 * shift(forms.foot) + 4 * reach * shift(forms.direction);
  };
  double largest = 0;
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
    largest =
        std::max(largest, apart(at.points.col(point), at_x.points.col(point)) + shift(builder_.point(point)));
  const double size = builder_.scene().size();
  for (int line = 0; line < static_cast<int>(problem.lines.size()); ++line) {
    const auto i = static_cast<std::size_t>(line);
    const LineForms& forms = builder_.line(problem.line_entity(line));
    const Eigen::Vector3cd &u = at.lines[i].direction, &v = at_x.lines[i].direction;
    largest =
        std::max({largest, apart(at.lines[i].point, at_x.lines[i].point) + foot_shift(forms, at_x.lines[i]),
                  size * (std::min(apart(u, v), apart(u, -v)) + shift(forms.direction))});
  }
  for (int plane = 0; plane < static_cast<int>(problem.planes.size()); ++plane) {
    const auto i = static_cast<std::size_t>(plane);
    const PlaneForms& forms = builder_.plane(problem.plane_entity(plane));
    largest =
        std::max({largest, size * (apart(at.planes[i].normal, at_x.planes[i].normal) + shift(forms.normal)),
                  std::abs(at.planes[i].offset - at_x.planes[i].offset) + shift_of(forms.offset, offsets)});
  }
  return largest;
}

Figure SceneSystem::figure(const ComplexValues& x, bool is_real) const {
  ComplexValues values = x;
  for (std::complex<double>& value : values)
    if (is_real) value = value.real();
  return figure_of(builder_.placement(values), is_real, builder_.turned_planes());
}

}  // namespace gcs
