#include "harness/results/certificate_limit.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/element_bound.hpp"
#include "solvers/counting/general_bound.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/counting/three_lines_bound.hpp"
#include "solvers/counting/wheel_bound.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/structure/decomposition.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {
namespace {

/// By the exact number of a part or its bound; nothing where there is none, or it is not of the part as a whole.
std::optional<JsonMembers> part_argument(const ProblemStatement& part) {
  const TheoreticalCounts counts = theoretical_counts(part);
  if (counts.exact)
    return JsonMembers{{"argument", json_text(part.dimension == 2 ? "realisation count" : "cone")},
                       {"at_most", json_count(counts.exact->fixed_frame)}};
  if (!counts.bound || counts.bound->parts != 1) return std::nullopt;
  const CountBound& bound = *counts.bound;
  const JsonValue at_most = json_count(bound.count.fixed_frame);
  const auto names = [&](const std::vector<int>& points) { return names_value(part, points); };
  if (!bound.ring.empty())
    return JsonMembers{{"argument", json_text("ring of bodies")},
                       {"at_most", at_most},
                       {"bodies", json_array_of(bound.ring, names)}};
  return JsonMembers{{"argument", json_text("m-Bézout bound")},
                     {"at_most", at_most},
                     {"held", names(bound.reference)},
                     {"at_infinity", json_array_of(bound.at_infinity, names)}};
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

std::vector<int> given_entities(const ProblemStatement& problem) {
  std::vector<int> given;
  for (const BodyElement& element : given_elements(problem)) given.push_back(element.entity);
  return given;
}

/// The elements of a part that is solved in one piece, and what is stated between them.
class UndividedPart {
 public:
  UndividedPart(const Scene& scene, const std::vector<bool>& is_left)
      : problem_(scene.problem()),
        line_(scene.reference().line < 0 ? -1 : problem_.line_entity(scene.reference().line)),
        graph_{
            problem_.dimension, {}, std::vector<bool>(is_left.size(), false), {}, problem_.planes.empty()} {
    for (int entity = 0; entity < problem_.entity_count(); ++entity)
      (is_left[static_cast<std::size_t>(entity)] ? part_ : later_).push_back(entity);
    for (const DistanceConstraint& c : problem_.constraints) add_edge(c.between[0], c.between[1]);
    for (const Relation& relation : problem_.relations)
      add_edge(relation.of[0].entity, relation.of[1].entity);
  }

  /// Nothing where a line is left that the frame does not hold, or where counting takes too long.
  std::optional<JsonValue> limit() {
    const std::vector<int> given = given_entities(problem_);
    if (std::ranges::any_of(part_, [&](int entity) { return problem_.is_line(entity) && entity != line_; }))
      return std::nullopt;
    if (problem_.dimension == 2)
      if (const auto counts = theoretical_counts(problem_); counts.exact)
        return value("realisation count", counts.exact->fixed_frame, {});
    if (const auto of_wheel = is_free_and_beside_line() ? wheel_bound(graph_) : std::nullopt)
      return value("wheel beside a line", *of_wheel / 2U, {});  // see below
    const std::vector<std::vector<int>> frames =
        given.empty() ? free_frames() : std::vector<std::vector<int>>{given};
    for (const std::vector<int>& frame : frames) {
      graph_.references.push_back(frame);
      graph_.references.back().insert(graph_.references.back().end(), later_.begin(), later_.end());
    }
    const auto bound = smallest_bezout_bound(graph_);
    if (!bound) return std::nullopt;
    const std::vector<int>& held = frames[bound->reference];
    // A line and a point leave two reflections, d points one.
    return value("m-Bézout bound", bound->fixed_frame / (held.front() == line_ ? 2U : 1U),
                 {{"held", names_value(problem_, held)},
                  {"at_infinity", json_array_of(bound->at_infinity, [&](const std::vector<int>& points) {
                     return names_value(problem_, points);
                   })}});
  }

 private:
  /// All lengths are above 0.
  bool is_free_and_beside_line() const {
    return line_ >= 0 && later_.empty() && !problem_.is_anchored() &&
           std::ranges::all_of(problem_.constraints,
                               [](const DistanceConstraint& c) { return c.given.value > 0; });
  }

  void add_edge(int a, int b) {
    if (a > b) std::swap(a, b);
    if (!problem_.is_line(b))
      graph_.edges.push_back({a, b});
    else if (b == line_)
      graph_.on_line[static_cast<std::size_t>(a)] = true;
  }

  /// The line that the frame holds and a point beside it, or three points with all their distances given.
  std::vector<std::vector<int>> free_frames() const {
    std::vector<std::vector<int>> frames;
    const auto points = static_cast<int>(problem_.points.size());
    const auto are_joined = [&](int a, int b) {
      return std::ranges::count(graph_.edges, std::array{a, b}) > 0;
    };
    for (int a = 0; a < points; ++a) {
      if (line_ >= 0 && graph_.on_line[static_cast<std::size_t>(a)]) frames.push_back({line_, a});
      for (int b = a + 1; b < points && line_ < 0; ++b)
        for (int c = b + 1; c < points && are_joined(a, b); ++c)
          if (are_joined(a, c) && are_joined(b, c)) frames.push_back({a, b, c});
    }
    return frames;
  }

  JsonValue value(const char* argument, const Natural& at_most, JsonMembers members) const {
    members.emplace_back("argument", json_text(argument));
    members.emplace_back("at_most", json_count(at_most));
    members.emplace_back("points", names_value(problem_, part_));
    return json_object(std::move(members));
  }

  const ProblemStatement& problem_;
  int line_;  ///< that the frame puts on its axis; −1: none
  BoundProblem graph_;
  std::vector<int> part_, later_;
};

std::optional<std::vector<JsonValue>> parts_without_hung_lines(const Scene& scene,
                                                               const std::vector<bool>& is_left) {
  const ProblemStatement rest = sub_problem(scene.problem(), is_left).problem;
  if (static_cast<int>(given_entities(rest).size()) == rest.entity_count()) return std::vector<JsonValue>();
  if (!rest.is_general() && rest.lines.empty() && !rest.is_anchored()) return parts_of_points(rest);
  const auto undivided = UndividedPart(scene, is_left).limit();
  return undivided ? std::optional(std::vector<JsonValue>{*undivided}) : std::nullopt;
}

bool has_own_bound(const ProblemStatement& problem, const Relation& relation) {
  using enum OperandKind;
  std::vector<OperandKind> kinds;
  for (const Operand& of : relation.of) kinds.push_back(kind_of(problem, of));
  std::ranges::sort(kinds);
  return (relation.type == "distance" && kinds == std::vector{point, plane}) ||
         (relation.type == "angle" && kinds == std::vector{plane, plane});
}

/// Points, lines and planes with distances from points, and angles of planes, of which other theorems are known.
bool is_of_distances(const ProblemStatement& problem) {
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity) && !problem.is_point(entity)) return false;
  return problem.bodies.empty() && (problem.dimension == 3 || problem.lines.empty()) &&
         std::ranges::all_of(problem.relations, [&](const Relation& r) { return has_own_bound(problem, r); });
}

JsonValue set_value(const ProblemStatement& problem, const PlacedSet& set) {
  JsonMembers members{{"argument", json_text(set.is_body ? "body on legs" : "m-Bézout bound")},
                      {"at_most", json_count(set.at_most)},
                      {"points", names_value(problem, set.elements)}};
  if (!set.is_body) members.emplace_back("held", names_value(problem, set.held));
  return json_object(std::move(members));
}

std::vector<int> all_entities(const ProblemStatement& problem) {
  std::vector<int> all(static_cast<std::size_t>(problem.entity_count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
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
  if (auto same_equations = without_orientations(problem))
    return certificate_limit(Scene::unchecked(std::move(*same_equations)));
  if (const auto most = three_lines_bound(problem))
    return json_array({json_object({{"argument", json_text("three lines")},
                                    {"at_most", json_count(Natural(*most))},
                                    {"points", names_value(problem, all_entities(problem))}})});
  if (!is_of_distances(problem)) {
    const auto sets = placed_sets(problem);
    return sets ? json_array_of(*sets, [&](const PlacedSet& set) { return set_value(problem, set); })
                : json_null();
  }
  const std::vector<bool> is_hung = hung_lines(problem);
  std::vector<bool> is_left = is_hung;
  is_left.flip();
  auto values = parts_without_hung_lines(scene, is_left);
  if (!values) return json_null();
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (is_hung[static_cast<std::size_t>(entity)]) values->push_back(hung_line_value(problem, entity));
  return json_array(std::move(*values));
}

}  // namespace gcs
