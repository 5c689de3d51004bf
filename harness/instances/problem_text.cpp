#include "harness/instances/problem_text.hpp"

#include <algorithm>

#include "solvers/elements/given_elements.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/relation_words.hpp"

namespace gcs {
namespace {

/// As the file writes it, or the double's own text where there is none.
JsonValue decimal_value(double value, const std::string& text) {
  JsonValue result = json_number(value);
  if (!text.empty()) result.text = text;
  return result;
}

JsonValue distance_value(const ProblemStatement& problem, const DistanceConstraint& constraint) {
  return json_object(
      {{"id", json_text(constraint.id)},
       {"type", json_text("distance")},
       {"between", json_texts({problem.name(constraint.between[0]), problem.name(constraint.between[1])})},
       {constraint.is_squared ? "squared" : "length",
        decimal_value(constraint.given.value, constraint.given.text)}});
}

/// A name, or the two of a segment.
JsonValue operand_value(const ProblemStatement& problem, const Operand& operand) {
  const std::string& name = problem.name(operand.entity);
  return operand.is_segment() ? json_texts({name, problem.name(operand.end)}) : json_text(name);
}

JsonValue relation_value(const ProblemStatement& problem, const Relation& relation) {
  const bool is_orientation = relation.sign != 0;
  JsonMembers members{
      {"id", json_text(relation.id)},
      {"type", json_text(relation.type)},
      {is_orientation ? "of" : "between",
       json_array_of(relation.of, [&](const Operand& operand) { return operand_value(problem, operand); })}};
  if (const std::string form = name_of(relation.form); !form.empty())
    members.emplace_back(form, decimal_value(relation.given.value, relation.given.text));
  if (is_orientation) members.emplace_back("sign", json_number(relation.sign));
  return json_object(std::move(members));
}

JsonValue constraints_value(const ProblemStatement& problem) {
  std::vector<JsonValue> constraints;
  for (const DistanceConstraint& constraint : problem.constraints)
    constraints.push_back(distance_value(problem, constraint));
  for (const Relation& relation : problem.relations) constraints.push_back(relation_value(problem, relation));
  return json_array(std::move(constraints));
}

/// Where the element is, as the file writes it.
JsonValue body_element_value(const ProblemStatement& problem, const BodyElement& element) {
  std::vector<JsonValue> numbers;
  for (const Decimal& number : element.numbers) numbers.push_back(decimal_value(number.value, number.text));
  const auto vector = [&](int part) {
    const auto first = numbers.begin() + part * problem.dimension;
    return json_array({first, first + problem.dimension});
  };
  if (problem.is_point(element.entity)) return vector(0);
  return problem.is_line(element.entity) ? json_line(vector(0), vector(1))
                                         : json_plane(vector(0), numbers[3]);
}

JsonValue elements_value(const ProblemStatement& problem, const std::vector<BodyElement>& elements) {
  JsonMembers members;
  for (const BodyElement& element : elements)
    members.emplace_back(problem.name(element.entity), body_element_value(problem, element));
  return json_object(std::move(members));
}

JsonValue bodies_value(const ProblemStatement& problem) {
  JsonMembers bodies;
  for (const RigidBody& body : problem.bodies)
    bodies.emplace_back(body.name, elements_value(problem, body.elements));
  return json_object(std::move(bodies));
}

/// Of the entities from `first` on those that are in no body.
JsonValue free_names(const ProblemStatement& problem, const std::vector<std::string>& names, int first) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (common_body(problem, {first + static_cast<int>(i)}) < 0) result.push_back(names[i]);
  return json_texts(result);
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

/// The frame of the scene, if the file can say it.
std::optional<JsonValue> frame_value(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (problem.has_fixed()) return std::nullopt;
  if (problem.reference_body >= 0)
    return json_object(
        {{"body", json_text(problem.bodies[static_cast<std::size_t>(problem.reference_body)].name)}});
  if (!problem.is_general()) return reference_value(problem, scene.reference());
  return problem.reference ? std::optional(reference_value(problem, *problem.reference)) : std::nullopt;
}

JsonValue sketch_value(const ProblemStatement& problem) {
  JsonValue positions = json_points(problem, *problem.sketch);
  for (const auto& more : {json_lines(problem, *problem.sketch), json_planes(problem, *problem.sketch)})
    positions.members.insert(positions.members.end(), more.members.begin(), more.members.end());
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
  const int lines = static_cast<int>(problem.points.size()),
            planes = lines + static_cast<int>(problem.lines.size());
  JsonMembers members{
      {"format", json_text(problem.is_general() ? "gcsbench-instance/2" : "gcsbench-instance/1")},
      {"id", json_text(id)},
      {"dimension", json_number(problem.dimension)},
      {"points", free_names(problem, problem.points, 0)},
      {"lines", free_names(problem, problem.lines, lines)}};
  if (!problem.planes.empty()) members.emplace_back("planes", free_names(problem, problem.planes, planes));
  if (!problem.bodies.empty()) members.emplace_back("bodies", bodies_value(problem));
  members.emplace_back("fixed", elements_value(problem, given_elements(problem)));
  members.emplace_back("constraints", constraints_value(problem));
  if (auto frame = frame_value(scene)) members.emplace_back("reference", std::move(*frame));
  if (problem.sketch) {
    members.emplace_back("sketch", sketch_value(problem));
    members.emplace_back("interpolation", interpolation_value(problem));
  }
  if (!problem.construction.empty()) members.emplace_back("construction", construction_value(problem));
  return to_text(json_object(std::move(members)), -1) + "\n";
}

}  // namespace gcs
