#include "solvers/reading/changed_value.hpp"

#include <algorithm>
#include <vector>

#include "solvers/reading/instance_values.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

const char* member_of(Relation::Form form) {
  switch (form) {
    case Relation::Form::none:
      break;
    case Relation::Form::length:
      return "length";
    case Relation::Form::squared:
      return "squared";
    case Relation::Form::degrees:
      return "degrees";
    case Relation::Form::cosine:
      return "cosine";
  }
  return "";
}

/// A distance between points, or of a point from a line, as the relation that it was read as.
Relation as_relation(const DistanceConstraint& constraint) {
  const Relation::Form form = constraint.is_squared ? Relation::Form::squared : Relation::Form::length;
  return {constraint.id, "distance", {{constraint.between[0]}, {constraint.between[1]}}, form};
}

/// What the decimal says of this relation, checked as a file's.
Decimal read_decimal(const ProblemStatement& problem, Relation relation, const std::string& number,
                     const std::string& source) {
  const JsonValue value = parse_json(number, source + " " + relation.id + "=" + number);
  const JsonValue stated = json_object({{member_of(relation.form), value}});
  const InstanceFormat format = problem.is_general() ? InstanceFormat::general : InstanceFormat::distances;
  read_value(JsonCursor(stated, source, "/" + escaped_for_pointer(relation.id)), format, problem, relation);
  return relation.given;
}

[[noreturn]] void refuse_unknown(const ProblemStatement& problem, const std::string& id,
                                 const std::string& source) {
  std::vector<std::string> ids;
  for (const DistanceConstraint& constraint : problem.constraints) ids.push_back(constraint.id);
  for (const Relation& relation : problem.relations)
    if (relation.form != Relation::Form::none) ids.push_back(relation.id);
  const JsonValue named = json_text(id);
  JsonCursor(named, source, "/" + escaped_for_pointer(id))
      .fail_unknown("no constraint with a value has the id '" + id + "'", id, ids);
}

}  // namespace

void change_value(ProblemStatement& problem, const std::string& id, const std::string& number,
                  const std::string& source) {
  const auto has_id = [&](const auto& one) { return one.id == id; };
  if (const auto found = std::ranges::find_if(problem.constraints, has_id);
      found != problem.constraints.end()) {
    found->given = read_decimal(problem, as_relation(*found), number, source);
    return;
  }
  const auto found = std::ranges::find_if(problem.relations, has_id);
  if (found == problem.relations.end() || found->form == Relation::Form::none)
    refuse_unknown(problem, id, source);
  found->given = read_decimal(problem, *found, number, source);
}

}  // namespace gcs
