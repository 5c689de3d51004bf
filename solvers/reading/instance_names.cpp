#include "solvers/reading/instance_names.hpp"

#include <algorithm>

#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

std::optional<int> position(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
}

std::vector<std::string> body_names(const ProblemStatement& problem) {
  std::vector<std::string> names;
  for (const RigidBody& body : problem.bodies) names.push_back(body.name);
  return names;
}

/// What the cursor's text names is not what is asked for, `wanted`, but something else that there is.
void refuse_other_kind(const ProblemStatement& problem, const std::string& name, const JsonCursor& cursor,
                       const std::string& wanted) {
  const std::string remedy = "name " + wanted;
  if (position(problem.points, name)) cursor.fail("'" + name + "' is a point", remedy);
  if (position(problem.lines, name)) cursor.fail("'" + name + "' is a line", remedy);
  if (position(problem.planes, name)) cursor.fail("'" + name + "' is a plane", remedy);
  if (position(body_names(problem), name)) cursor.fail("'" + name + "' is a body", remedy);
}

}  // namespace

int point_number(const ProblemStatement& problem, const JsonCursor& cursor) {
  const std::string name = cursor.name();
  if (const auto point = position(problem.points, name)) return *point;
  refuse_other_kind(problem, name, cursor, "a point");
  cursor.fail_unknown("there is no point '" + name + "'", name, problem.points);
}

int line_number(const ProblemStatement& problem, const JsonCursor& cursor) {
  const std::string name = cursor.name();
  if (const auto line = position(problem.lines, name)) return *line;
  refuse_other_kind(problem, name, cursor, "a line");
  cursor.fail_unknown("there is no line '" + name + "'", name, problem.lines);
}

int body_number(const ProblemStatement& problem, const JsonCursor& cursor) {
  const std::string name = cursor.name();
  const std::vector<std::string> names = body_names(problem);
  if (const auto body = position(names, name)) return *body;
  refuse_other_kind(problem, name, cursor, "a body");
  cursor.fail_unknown("there is no body '" + name + "'", name, names);
}

int entity_number(const ProblemStatement& problem, const std::string& name, const JsonCursor& cursor) {
  const auto points = static_cast<int>(problem.points.size()), lines = static_cast<int>(problem.lines.size());
  if (const auto point = position(problem.points, name)) return *point;
  if (const auto line = position(problem.lines, name)) return points + *line;
  if (const auto plane = position(problem.planes, name)) return points + lines + *plane;
  refuse_other_kind(problem, name, cursor, "one of its elements");
  std::vector<std::string> valid = problem.points;
  valid.insert(valid.end(), problem.lines.begin(), problem.lines.end());
  valid.insert(valid.end(), problem.planes.begin(), problem.planes.end());
  cursor.fail_unknown(std::string(problem.planes.empty() ? "there is no point or line '"
                                                         : "there is no point, line or plane '") +
                          name + "'",
                      name, valid);
}

void refuse_planes_in_the_plane(const JsonCursor& planes) {
  planes.fail("planes are for space only", "leave them out or give \"dimension\": 3");
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
