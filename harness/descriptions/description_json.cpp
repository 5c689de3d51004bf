#include "harness/descriptions/description_json.hpp"

#include <cmath>

#include "harness/solving/counts_view.hpp"
#include "harness/solving/frame_view.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

JsonValue freedom_value(const Structure& structure) {
  return json_object({{"unknowns", json_number(structure.unknowns)},
                      {"constraints", json_number(structure.constraints)},
                      {"generic_rank", json_number(structure.generic_rank)},
                      {"rigid", json_boolean(structure.generic_rank == structure.unknowns)}});
}

/// Null where there are no equations.
JsonValue freedom_value(const GeneralFacts& facts) {
  if (facts.why_no_system) return json_null();
  return json_object({{"unknowns", json_number(facts.unknowns)},
                      {"equations", json_number(facts.equations)},
                      {"rigid", json_boolean(!facts.why_not_rigid)},
                      {"why_not_rigid", json_or_null(facts.why_not_rigid, json_text)}});
}

JsonValue bodies_value(const ProblemStatement& problem) {
  JsonMembers members;
  for (const RigidBody& body : problem.bodies) {
    std::vector<int> entities;
    for (const BodyElement& element : body.elements) entities.push_back(element.entity);
    members.emplace_back(body.name, json_texts(names(problem, entities)));
  }
  return json_object(std::move(members));
}

JsonValue end_value(double t) { return std::isfinite(t) ? json_number(t) : json_null(); }

JsonValue interpolation_value(const ProblemStatement& problem, const DistanceFacts& facts) {
  if (!problem.sketch) return json_null();
  JsonMembers members;
  const std::vector<BentLength> bends = bent_lengths(problem);
  if (problem.interpolation.bends) {
    JsonMembers all;
    for (const BentLength& bent : bends)
      all.emplace_back(problem.constraints[bent.constraint].id,
                       json_array_of(bent.coefficients, json_number));
    members.emplace_back("bends", json_object(std::move(all)));
  } else {
    members.emplace_back("bent", json_text(problem.constraints[bends.front().constraint].id));
    members.emplace_back("bend", json_number(bends.front().coefficients.front()));
  }
  if (const auto& support = facts.positive_support) {
    members.emplace_back("positive_support", json_array({end_value(support->low), end_value(support->high)}));
    members.emplace_back("compact", json_boolean(support->is_bounded()));
  }
  return json_object(std::move(members));
}

JsonValue core_value(const ProblemStatement& problem, const CoreReduction& reduction) {
  std::vector<std::string> constraints;
  for (const int i : reduction.core_constraints) constraints.push_back(problem.constraints[i].id);
  std::vector<JsonValue> placed;
  for (const PlacedPoint& point : reduction.placed)
    placed.push_back(json_object(
        {{"place", json_text(problem.name(point.point))}, {"from", json_texts(names(problem, point.from))}}));
  return json_object({{"trivial", json_boolean(reduction.core_is_trivial)},
                      {"entities", json_texts(names(problem, reduction.core))},
                      {"constraints", json_texts(constraints)},
                      {"placed", json_array(std::move(placed))}});
}

JsonValue parts_value(const ProblemStatement& problem, const std::vector<Part>& parts) {
  std::vector<JsonValue> values;
  for (const Part& part : parts)
    values.push_back(json_object({{"base", json_texts(names(problem, part.base))},
                                  {"places", json_texts(names(problem, part.points))},
                                  {"hung", json_boolean(part.is_hung_point())}}));
  return json_array(std::move(values));
}

JsonValue plan_value(const ConstructionPlan& plan) {
  return json_object({{"given", json_boolean(plan.given)},
                      {"driving_parameters", json_count(plan.driving_parameters)},
                      {"removed", json_texts(plan.removed)},
                      {"instructions", json_texts(plan.instructions)}});
}

JsonValue strategies_value(const std::vector<StrategyVerdict>& strategies) {
  std::vector<JsonValue> values;
  for (const StrategyVerdict& verdict : strategies)
    values.push_back(json_object({{"name", json_text(verdict.name)},
                                  {"applies", json_boolean(!verdict.why_not)},
                                  {"why_not", json_or_null(verdict.why_not, json_text)}}));
  return json_array(std::move(values));
}

JsonValue frame_value(const Description& description) {
  JsonMembers members;
  for (const auto& [part, name] : description.frame) members.emplace_back(part, json_text(name));
  return json_object(std::move(members));
}

}  // namespace

std::string json_description(const Description& description) {
  const Instance& instance = description.instance;
  const ProblemStatement& problem = instance.problem;
  const JsonValue* published = instance.document.find("published");
  const std::optional<DistanceFacts>& facts = description.distances;
  JsonMembers members{{"id", json_text(instance.id)},
                      {"title", json_text(instance.title)},
                      {"dimension", json_number(problem.dimension)},
                      {"points", json_texts(problem.points)},
                      {"lines", json_texts(problem.lines)}};
  if (description.general) {
    members.emplace_back("planes", json_texts(problem.planes));
    members.emplace_back("bodies", bodies_value(problem));
  }
  JsonMembers rest{
      {"fixed", json_texts(fixed_names(problem))},
      {"degrees_of_freedom", facts ? freedom_value(facts->structure) : freedom_value(*description.general)},
      {"reference", facts ? frame_value(description) : json_null()},
      {"frame", frame_value(description)},
      {"convention", json_text(std::string(word(convention_of(problem))))},
      {"sketch", json_boolean(problem.sketch.has_value())},
      {"theoretical_counts", counts_value(problem, description.counts)},
      {"strategies", strategies_value(description.strategies)},
      {"published", published ? *published : json_array({})}};
  members.insert(members.end(), rest.begin(), rest.end());
  const auto of_distances = [&](const char* name, auto value) {
    members.emplace_back(name, json_or_null(facts, value));
  };
  of_distances("interpolation", [&](const DistanceFacts& f) { return interpolation_value(problem, f); });
  of_distances("core", [&](const DistanceFacts& f) { return core_value(problem, f.reduction); });
  of_distances("parts", [&](const DistanceFacts& f) { return parts_value(problem, f.parts); });
  members.emplace_back("construction",
                       description.plan.why_none.empty() ? plan_value(description.plan) : json_null());
  return to_text(json_object(std::move(members)), 1) + "\n";
}

}  // namespace gcs
