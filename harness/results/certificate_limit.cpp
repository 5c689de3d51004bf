#include "harness/results/certificate_limit.hpp"

#include <algorithm>
#include <array>
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
        graph_{problem_.dimension, {}, std::vector<bool>(is_left.size(), false), {}} {
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
                 {{"held", names_value(problem_, held)}});
  }

 private:
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

/// Whether a relation is a number of equations of two elements, each of one degree in either, as the checker counts them.
bool is_of_two_elements(const Relation& relation) {
  return relation.of.size() == 2 &&
         std::ranges::none_of(relation.of, [](const Operand& of) { return of.is_segment(); });
}

/// Of a relation of two elements.
int equations_of(const ProblemStatement& problem, const Relation& relation) {
  using enum OperandKind;
  const bool has_point = problem.is_point(relation.of[0].entity) || problem.is_point(relation.of[1].entity);
  const int planes = static_cast<int>(
      std::ranges::count_if(relation.of, [&](const Operand& of) { return kind_of(problem, of) == plane; }));
  const bool is_double = (relation.type == "on" && has_point == (planes == 0)) ||
                         (relation.type == "parallel" && planes != 1) ||
                         (relation.type == "perpendicular" && planes == 1);
  return is_double && problem.dimension == 3 ? 2 : 1;
}

/// Points, lines and planes with distances from points, and angles of planes, of which other theorems are known.
bool is_of_distances(const ProblemStatement& problem) {
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity) && !problem.is_point(entity)) return false;
  return problem.bodies.empty() && (problem.dimension == 3 || problem.lines.empty()) &&
         std::ranges::all_of(problem.relations, [&](const Relation& r) { return has_own_bound(problem, r); });
}

/// Places the elements of a scene one set after the other.
class PlacedParts {
 public:
  explicit PlacedParts(const Scene& scene)
      : problem_(scene.problem()), is_placed_(static_cast<std::size_t>(problem_.entity_count())) {
    for (int entity = 0; entity < problem_.entity_count(); ++entity)
      is_placed_[static_cast<std::size_t>(entity)] = rests(entity);
  }

  /// Nothing where there is no limit.
  std::optional<std::vector<JsonValue>> limit() {
    if (!std::ranges::all_of(problem_.relations, is_of_two_elements)) return std::nullopt;
    if (std::ranges::count(is_placed_, true) == 0) {
      const std::vector<int> held = joined_points();
      if (held.empty()) return std::nullopt;
      place(held, held);
    }
    for (bool goes_on = true; goes_on;)
      goes_on = place_hung_element() ||
                std::ranges::any_of(problem_.bodies, [&](const RigidBody& body) { return place(body); });
    return place_rest() ? std::optional(std::move(values_)) : std::nullopt;
  }

 private:
  bool rests(int entity) const {
    return problem_.is_fixed(entity) ||
           std::ranges::count(bodies_with(problem_, entity), problem_.reference_body) > 0;
  }
  bool is_placed(int entity) const { return is_placed_[static_cast<std::size_t>(entity)]; }
  bool is_held_by(const DistanceConstraint& distance, const std::vector<int>& body) const {
    const auto& [a, b] = distance.between;
    return (std::ranges::count(body, a) > 0 && is_placed(b)) ||
           (std::ranges::count(body, b) > 0 && is_placed(a));
  }

  /// A body of points on as many legs as those that are placed leave freedoms; false where it is none, or is placed.
  bool place(const RigidBody& body) {
    std::vector<int> moved, part;
    for (const BodyElement& element : body.elements) {
      part.push_back(element.entity);
      if (!is_placed(element.entity)) moved.push_back(element.entity);
    }
    const auto shared = static_cast<int>(part.size() - moved.size());
    if (moved.empty() || !std::ranges::all_of(part, [&](int entity) { return problem_.is_point(entity); }))
      return false;
    int legs = 0;
    for (const DistanceConstraint& distance : problem_.constraints) {
      if (!is_held_by(distance, moved)) continue;
      ++legs;
      for (const int end : distance.between)
        if (std::ranges::count(part, end) == 0) part.push_back(end);
    }
    if (legs != freedoms_left(shared)) return false;
    values_.push_back(
        json_object({{"argument", json_text("body on legs")}, {"points", names_value(problem_, part)}}));
    mark(moved);
    return true;
  }

  /// By given places of so many points; −1: of more than an axis.
  int freedoms_left(int points) const {
    constexpr std::array in_space{6, 3, 1}, in_the_plane{3, 1, -1};
    if (points > 2) return -1;
    return (problem_.dimension == 3 ? in_space : in_the_plane)[static_cast<std::size_t>(points)];
  }

  void mark(const std::vector<int>& entities) {
    for (const int entity : entities) is_placed_[static_cast<std::size_t>(entity)] = true;
  }

  void place(const std::vector<int>& part, const std::vector<int>& held) {
    values_.push_back(json_object({{"argument", json_text("m-Bézout bound")},
                                   {"points", names_value(problem_, part)},
                                   {"held", names_value(problem_, held)}}));
    mark(part);
  }

  bool is_of_a_body(int entity) const { return !bodies_with(problem_, entity).empty(); }

  int freedoms(int entity) const {
    return problem_.is_line(entity) ? 2 * problem_.dimension - 2 : 3 - (problem_.dimension == 2 ? 1 : 0);
  }

  /// Takes the neighbour among the ends, if it is placed, into `base`, and counts equations.
  void count(int entity, int a, int b, int equations, std::vector<int>& base, int& sum) const {
    const int other = a == entity ? b : a;
    if ((a != entity && b != entity) || !is_placed(other)) return;
    if (std::ranges::count(base, other) == 0) base.push_back(other);
    sum += equations;
  }

  /// One that has as many equations with what is placed as freedoms.
  bool place_hung_element() {
    for (int entity = 0; entity < problem_.entity_count(); ++entity) {
      if (is_placed(entity) || is_of_a_body(entity)) continue;
      std::vector<int> base;
      int equations = 0;
      for (const DistanceConstraint& c : problem_.constraints)
        count(entity, c.between[0], c.between[1], 1, base, equations);
      for (const Relation& relation : problem_.relations)
        count(entity, relation.of[0].entity, relation.of[1].entity, equations_of(problem_, relation), base,
              equations);
      if (equations != freedoms(entity)) continue;
      std::vector<int> part = base;
      part.push_back(entity);
      place(part, base);
      return true;
    }
    return false;
  }

  /// All in one part. False where it has bodies.
  bool place_rest() {
    std::vector<int> all, held;
    for (int entity = 0; entity < problem_.entity_count(); ++entity) {
      all.push_back(entity);
      if (is_placed(entity))
        held.push_back(entity);
      else if (is_of_a_body(entity))
        return false;
    }
    if (held.size() < all.size()) place(all, held);
    return true;
  }

  bool are_joined(int a, int b) const {
    return std::ranges::any_of(problem_.constraints, [&](const DistanceConstraint& c) {
      return c.between == std::array{a, b} || c.between == std::array{b, a};
    });
  }

  std::vector<int> joined_points() const {
    const auto points = static_cast<int>(problem_.points.size());
    for (int a = 0; a < points; ++a)
      for (int b = a + 1; b < points; ++b) {
        if (!are_joined(a, b)) continue;
        if (problem_.dimension == 2) return {a, b};
        for (int c = b + 1; c < points; ++c)
          if (are_joined(a, c) && are_joined(b, c)) return {a, b, c};
      }
    return {};
  }

  const ProblemStatement& problem_;
  std::vector<bool> is_placed_;
  std::vector<JsonValue> values_;
};

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
  if (!is_of_distances(problem)) {
    auto values = PlacedParts(scene).limit();
    return values ? json_array(std::move(*values)) : json_null();
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
