#include "solvers/reading/instance_names.hpp"

#include <algorithm>

#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

std::optional<int> position(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
}

}  // namespace

int point_number(const ProblemStatement& problem, const JsonCursor& cursor) {
  const std::string name = cursor.name();
  if (const auto point = position(problem.points, name)) return *point;
  if (position(problem.lines, name)) cursor.fail("'" + name + "' is a line", "name a point");
  cursor.fail_unknown("there is no point '" + name + "'", name, problem.points);
}

int line_number(const ProblemStatement& problem, const JsonCursor& cursor) {
  const std::string name = cursor.name();
  if (const auto line = position(problem.lines, name)) return *line;
  if (position(problem.points, name)) cursor.fail("'" + name + "' is a point", "name a line");
  cursor.fail_unknown("there is no line '" + name + "'", name, problem.lines);
}

int entity_number(const ProblemStatement& problem, const std::string& name, const JsonCursor& cursor) {
  if (const auto point = position(problem.points, name)) return *point;
  if (const auto line = position(problem.lines, name)) return static_cast<int>(problem.points.size()) + *line;
  std::vector<std::string> valid = problem.points;
  valid.insert(valid.end(), problem.lines.begin(), problem.lines.end());
  cursor.fail_unknown("there is no point or line '" + name + "'", name, valid);
}

std::optional<int> constraint_number(const ProblemStatement& problem, const std::string& id) {
  const auto found = std::find_if(problem.constraints.begin(), problem.constraints.end(),
                                  [&](const DistanceConstraint& constraint) { return constraint.id == id; });
  if (found == problem.constraints.end()) return std::nullopt;
  return static_cast<int>(found - problem.constraints.begin());
}

std::vector<std::string> constraint_ids(const ProblemStatement& problem) {
  std::vector<std::string> ids;
  for (const DistanceConstraint& constraint : problem.constraints) ids.push_back(constraint.id);
  return ids;
}

std::string entity_names(const ProblemStatement& problem, const std::vector<int>& entities) {
  std::vector<std::string> names;
  for (const int entity : entities) names.push_back(problem.name(entity));
  return quoted_list(names);
}

}  // namespace gcs
