#include "harness/results/certificate_limit.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/general_bound.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/structure/decomposition.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {
namespace {

/// By the exact number of a part or its bound; nothing where there is none, or it is not of the part as a whole.
std::optional<JsonMembers> part_argument(const ProblemStatement& part) {
  const TheoreticalCounts counts = theoretical_counts(part);
  if (part.dimension == 2 && counts.exact)
    return JsonMembers{{"argument", json_text("realisation count")},
                       {"at_most", json_count(counts.exact->fixed_frame)}};
  if (!counts.bound || counts.bound->parts != 1) return std::nullopt;
  const CountBound& bound = *counts.bound;
  const JsonValue at_most = json_count(bound.count.fixed_frame);
  if (bound.ring.empty())
    return JsonMembers{{"argument", json_text("m-Bézout bound")},
                       {"at_most", at_most},
                       {"held", names_value(part, bound.reference)}};
  const auto body_value = [&](const std::vector<int>& body) { return names_value(part, body); };
  return JsonMembers{{"argument", json_text("ring of bodies")},
                     {"at_most", at_most},
                     {"bodies", json_array_of(bound.ring, body_value)}};
}

/// Of points with distances between them: each part while those before it are held. Nothing where a part has no limit.
std::optional<std::vector<JsonValue>> parts_of_points(const ProblemStatement& problem) {
  std::vector<JsonValue> values;
  for (const Part& part : decompose(problem, Split::all)) {
    std::optional<JsonMembers> members;
    if (part.is_hung_point())
      members = JsonMembers{{"argument", json_text("hung point")}, {"at_most", json_number(2)}};
    else
      members = part_argument(part_problem(problem, part).problem);
    if (!members) return std::nullopt;
    std::vector<int> points = part.base;
    points.insert(points.end(), part.points.begin(), part.points.end());
    members->emplace_back("points", names_value(problem, points));
    values.push_back(json_object(std::move(*members)));
  }
  return values;
}

/// The elements that the frame holds: those with given positions, a line and a point, or d points.
std::vector<int> held_elements(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const Reference& reference = scene.reference();
  std::vector<int> held;
  for (const BodyElement& element : given_elements(problem)) held.push_back(element.entity);
  if (!held.empty()) return held;
  if (reference.line >= 0) return {problem.line_entity(reference.line), reference.height};
  held = {reference.origin, reference.axis, reference.plane};
  held.resize(static_cast<std::size_t>(problem.dimension));
  return held;
}

/// In the plane, with bars that hold given points to each other: all but two of them have two places each then, which have
/// equally many figures, as positions of these points are one irreducible family.
std::optional<Natural> count_around(ProblemStatement problem, const std::vector<int>& given) {
  problem.fixed_points.clear();
  problem.fixed_texts.clear();
  for (std::size_t i = 1; i < given.size(); ++i)
    for (std::size_t j = 0; j < std::min<std::size_t>(i, 2); ++j)
      problem.constraints.push_back({"", {given[i], given[j]}, {1, "1"}, false});
  const TheoreticalCounts counts = theoretical_counts(problem);
  if (!counts.exact) return std::nullopt;
  Natural count = counts.exact->fixed_frame;
  for (std::size_t i = 2; i < given.size(); ++i) count = count / 2U;
  return count;
}

/// The m-Bézout bound of all that `is_left`, planes as points, with what the frame holds. Nothing where no line is held
/// and one is left, or where it takes too long.
std::optional<std::vector<JsonValue>> part_in_frame(const Scene& scene, const std::vector<bool>& is_left) {
  const ProblemStatement& problem = scene.problem();
  const std::vector<int> held = held_elements(scene);
  BoundProblem graph{problem.dimension, {}, std::vector<bool>(is_left.size(), false), {held}};
  std::vector<int> part;
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    const bool is_in_part = is_left[static_cast<std::size_t>(entity)];
    if (is_in_part) part.push_back(entity);
    if (is_in_part && problem.is_line(entity) && held.front() != entity) return std::nullopt;
    if (!is_in_part) graph.references.front().push_back(entity);
  }
  const auto add_edge = [&](int a, int b) {
    if (problem.is_line(b))
      graph.on_line[static_cast<std::size_t>(a)] = b == held.front();
    else
      graph.edges.push_back({a, b});
  };
  for (const DistanceConstraint& c : problem.constraints)
    add_edge(std::min(c.between[0], c.between[1]), std::max(c.between[0], c.between[1]));
  for (const Relation& relation : problem.relations) add_edge(relation.of[0].entity, relation.of[1].entity);
  if (problem.dimension == 2)
    if (const auto count = count_around(problem, held))
      return std::vector{json_object({{"argument", json_text("realisation count")},
                                      {"at_most", json_count(*count)},
                                      {"points", names_value(problem, part)}})};
  const auto bound = smallest_bezout_bound(graph);
  if (!bound) return std::nullopt;
  // A line and a point leave two reflections, d points one.
  const Natural at_most = bound->fixed_frame / (problem.is_line(held.front()) ? 2U : 1U);
  return std::vector{json_object({{"argument", json_text("m-Bézout bound")},
                                  {"at_most", json_count(at_most)},
                                  {"held", names_value(problem, held)},
                                  {"points", names_value(problem, part)}})};
}

/// A line at four distances from points.
JsonValue hung_line_value(const ProblemStatement& problem, int line) {
  std::vector<int> points{line};
  for (const DistanceConstraint& c : problem.constraints)
    for (const int side : {0, 1})
      if (c.between[side] == line) points.push_back(c.between[1 - side]);
  return json_object({{"argument", json_text("common tangents")},
                      {"at_most", json_number(12)},
                      {"points", names_value(problem, points)}});
}

}  // namespace

JsonValue names_value(const ProblemStatement& problem, const std::vector<int>& entities) {
  return json_array_of(entities, [&](int entity) { return json_text(problem.name(entity)); });
}

JsonValue certificate_limit(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const std::vector<bool> is_hung = hung_lines(problem);
  std::vector<bool> is_left = is_hung;
  is_left.flip();
  const ProblemStatement rest = sub_problem(problem, is_left).problem;
  const bool is_given = static_cast<int>(given_elements(rest).size()) == rest.entity_count();
  const bool is_of_points = !rest.is_general() && rest.lines.empty() && !rest.is_anchored();
  auto values = is_given       ? std::vector<JsonValue>()
                : is_of_points ? parts_of_points(rest)
                               : part_in_frame(scene, is_left);
  if (!values) return json_null();
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (is_hung[static_cast<std::size_t>(entity)]) values->push_back(hung_line_value(problem, entity));
  return json_array(std::move(*values));
}

}  // namespace gcs
