#include "harness/solving/frame_view.hpp"

#include "solvers/reading/json_build.hpp"

namespace gcs {

std::vector<std::pair<std::string, std::string>> frame_parts(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const Reference& reference = scene.reference();
  if (scene.is_anchored()) return {};
  if (problem.reference_body >= 0)
    return {{"body", problem.bodies[static_cast<std::size_t>(problem.reference_body)].name}};
  std::vector<std::pair<std::string, std::string>> parts;
  const auto append = [&](const char* part, int entity) {
    if (entity >= 0) parts.emplace_back(part, problem.name(entity));
  };
  append("origin", reference.origin);
  append("axis", reference.axis);
  append("plane", reference.plane);
  append("line", reference.line < 0 ? -1 : problem.line_entity(reference.line));
  append("height", reference.height);
  return parts;
}

std::vector<std::string> fixed_names(const ProblemStatement& problem) {
  std::vector<std::string> result;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity)) result.push_back(problem.name(entity));
  return result;
}

JsonValue frame_value(const Scene& scene) {
  JsonMembers members;
  if (scene.problem().has_fixed()) members.emplace_back("fixed", json_texts(fixed_names(scene.problem())));
  for (const auto& [part, name] : frame_parts(scene)) members.emplace_back(part, json_text(name));
  return json_object(std::move(members));
}

}  // namespace gcs
