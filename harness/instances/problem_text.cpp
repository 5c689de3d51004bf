#include "harness/instances/problem_text.hpp"

#include <algorithm>

#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

/// As the file writes it, or the double's own text where there is none.
JsonValue decimal_value(double value, const std::string& text) {
  JsonValue result = json_number(value);
  if (!text.empty()) result.text = text;
  return result;
}

/// Precondition: the point is fixed.
JsonValue fixed_point_value(const ProblemStatement& problem, std::size_t point) {
  JsonValue value = json_coordinates(*problem.fixed_points[point], problem.dimension);
  if (problem.fixed_point_texts.empty()) return value;
  for (std::size_t axis = 0; axis < value.elements.size(); ++axis)
    value.elements[axis] = decimal_value(value.elements[axis].number, problem.fixed_point_texts[point][axis]);
  return value;
}

JsonValue fixed_value(const ProblemStatement& problem) {
  JsonMembers members;
  for (std::size_t i = 0; i < problem.fixed_points.size(); ++i)
    if (problem.fixed_points[i]) members.emplace_back(problem.points[i], fixed_point_value(problem, i));
  for (std::size_t i = 0; i < problem.fixed_lines.size(); ++i)
    if (const auto& line = problem.fixed_lines[i])
      members.emplace_back(problem.lines[i], json_line_position(*line, problem.dimension));
  return json_object(std::move(members));
}

JsonValue constraints_value(const ProblemStatement& problem) {
  return json_array_of(problem.constraints, [&](const DistanceConstraint& constraint) {
    return json_object(
        {{"id", json_text(constraint.id)},
         {"type", json_text("distance")},
         {"between", json_texts({problem.name(constraint.between[0]), problem.name(constraint.between[1])})},
         {constraint.is_squared ? "squared" : "length",
          decimal_value(constraint.given.value, constraint.given.text)}});
  });
}

JsonValue reference_value(const ProblemStatement& problem, const Reference& reference) {
  JsonMembers members;
  const auto append = [&](const char* part, int number, const std::vector<std::string>& names) {
    if (number >= 0) members.emplace_back(part, json_text(names[static_cast<std::size_t>(number)]));
  };
  append("origin", reference.origin, problem.points);
  append("axis", reference.axis, problem.points);
  append("plane", reference.plane, problem.points);
  append("line", reference.line, problem.lines);
  append("height", reference.height, problem.points);
  return json_object(std::move(members));
}

JsonValue sketch_value(const ProblemStatement& problem) {
  JsonValue positions = json_points(problem, *problem.sketch), lines = json_lines(problem, *problem.sketch);
  for (auto& line : lines.members) positions.members.push_back(std::move(line));
  return positions;
}

JsonValue bends_value(const ProblemStatement& problem) {
  JsonMembers members;
  for (const BentLength& bent : *problem.interpolation.bends)
    members.emplace_back(problem.constraints[static_cast<std::size_t>(bent.constraint)].id,
                         json_array_of(bent.coefficients, json_number));
  return json_object(std::move(members));
}

JsonValue interpolation_value(const ProblemStatement& problem) {
  if (problem.interpolation.bends) return json_object({{"bends", bends_value(problem)}});
  JsonMembers members;
  if (const int bent = problem.interpolation.bent; bent >= 0)
    members.emplace_back("bent", json_text(problem.constraints[static_cast<std::size_t>(bent)].id));
  members.emplace_back("bend", json_number(problem.interpolation.bend));
  return json_object(std::move(members));
}

JsonValue radius_value(const ProblemStatement& problem, const PlanStep::Radius& radius) {
  const bool is_driving = radius.constraint < 0;
  return json_texts(
      {problem.name(radius.from),
       is_driving ? radius.driving : problem.constraints[static_cast<std::size_t>(radius.constraint)].id});
}

JsonValue construction_value(const ProblemStatement& problem) {
  const auto radius = [&](const PlanStep::Radius& r) { return radius_value(problem, r); };
  return json_array_of(problem.construction, [&](const PlanStep& step) {
    return json_object(
        {{"place", json_text(problem.name(step.place))}, {"from", json_array_of(step.from, radius)}});
  });
}

}  // namespace

std::string problem_text(const Scene& scene, const std::string& id) {
  const ProblemStatement& problem = scene.problem();
  JsonMembers members{{"format", json_text("gcsbench-instance/1")},  {"id", json_text(id)},
                      {"dimension", json_number(problem.dimension)}, {"points", json_texts(problem.points)},
                      {"lines", json_texts(problem.lines)},          {"fixed", fixed_value(problem)},
                      {"constraints", constraints_value(problem)}};
  if (!scene.is_anchored()) members.emplace_back("reference", reference_value(problem, scene.reference()));
  if (problem.sketch) {
    members.emplace_back("sketch", sketch_value(problem));
    members.emplace_back("interpolation", interpolation_value(problem));
  }
  if (!problem.construction.empty()) members.emplace_back("construction", construction_value(problem));
  return to_text(json_object(std::move(members)), -1) + "\n";
}

}  // namespace gcs
