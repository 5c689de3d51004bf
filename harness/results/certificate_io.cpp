#include "harness/results/certificate_io.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "harness/results/decimal_json.hpp"
#include "harness/solving/frame_view.hpp"
#include "solvers/certificates/dyadic_figure.hpp"
#include "solvers/certificates/solutions_at_infinity.hpp"
#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/general_bound.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/structure/decomposition.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {
namespace {

struct ProvenFigure {
  DyadicBox box;
  bool is_real;
};

/// `members` come first.
JsonValue box_value(JsonMembers members, const DyadicBox& box, bool is_real) {
  const auto number = [&](const DecimalNumber& one) { return json_decimal(one, is_real); };
  members.emplace_back("exponent", json_number(box.exponent));
  members.emplace_back("radius", json_text(std::to_string(DyadicBox::radius)));
  members.emplace_back("numbers", json_array_of(box.numbers, number));
  return json_object(std::move(members));
}

JsonValue solution_value(const ProvenFigure& proven) {
  return box_value({{"real", json_boolean(proven.is_real)}}, proven.box, proven.is_real);
}

JsonValue names_value(const ProblemStatement& problem, const std::vector<int>& points) {
  return json_array_of(points, [&](int point) { return json_text(problem.name(point)); });
}

JsonValue escape_value(const ProblemStatement& problem, const std::vector<Escape>& way,
                       const Escape& escape) {
  const auto crossed =
      std::ranges::find_if(way, [&](const Escape& other) { return other.number == escape.walk.across; });
  return json_object(
      {{"points", names_value(problem, escape.points)},
       {"walk", names_value(problem, escape.walk.corners)},
       {"signs", json_array_of(escape.walk.signs, json_number)},
       {"across",
        crossed == way.end() ? json_null() : json_count(static_cast<std::uint64_t>(crossed - way.begin()))}});
}

JsonValue solution_value(const DyadicAtInfinity::Solution& solution) {
  return box_value({{"way", json_count(solution.way)}}, solution.box, false);
}

/// Null where nothing is proven there.
JsonValue at_infinity_value(const Scene& scene, const Answer& answer) {
  if (answer.escaping.empty()) return json_null();
  std::vector<Figure> near;
  for (const Figure& figure : answer.escaping) near.push_back(scene.in_scene_unit(figure));
  const DyadicAtInfinity proven = dyadic_at_infinity(scene, near, answer.threads);
  if (proven.solutions.empty()) return json_null();
  const ProblemStatement& problem = scene.problem();
  const auto name = [&](int point) { return json_text(problem.name(point)); };
  const auto way_value = [&](const std::vector<Escape>& way) {
    return json_array_of(way, [&](const Escape& escape) { return escape_value(problem, way, escape); });
  };
  return json_object({{"frame", json_object({{"origin", name(proven.frame.origin)},
                                             {"axis", name(proven.frame.axis)},
                                             {"plane", name(proven.frame.plane)}})},
                      {"ways", json_array_of(proven.ways, way_value)},
                      {"solutions", json_array_of(proven.solutions, [](const auto& solution) {
                         return solution_value(solution);
                       })}});
}

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

/// A signed distance of a point and a plane, or the cosine of two planes.
bool is_certifiable(const ProblemStatement& problem, const Relation& relation) {
  using enum OperandKind;
  std::vector<OperandKind> kinds;
  for (const Operand& of : relation.of) kinds.push_back(kind_of(problem, of));
  std::ranges::sort(kinds);
  return (relation.type == "distance" && kinds == std::vector{point, plane}) ||
         (relation.form == Relation::Form::cosine && kinds == std::vector{plane, plane});
}

/// The elements that the frame holds: those with given positions, a line and a point, or d points.
std::vector<int> held_elements(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const Reference& reference = scene.reference();
  std::vector<int> held;
  if (scene.is_anchored()) {
    for (int entity = 0; entity < problem.entity_count(); ++entity)
      if (problem.is_fixed(entity)) held.push_back(entity);
    return held;
  }
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

/// How many solutions there can be, part by part, or null.
JsonValue limit_value(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const std::vector<bool> is_hung = hung_lines(problem);
  std::vector<bool> is_left = is_hung;
  is_left.flip();
  const ProblemStatement rest = sub_problem(problem, is_left).problem;
  const bool is_given = std::ranges::all_of(std::views::iota(0, rest.entity_count()),
                                            [&](int entity) { return rest.is_fixed(entity); });
  const bool is_of_points = !rest.is_general() && rest.lines.empty() && !rest.is_anchored();
  auto values = is_given       ? std::vector<JsonValue>()
                : is_of_points ? parts_of_points(rest)
                               : part_in_frame(scene, is_left);
  if (!values) return json_null();
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (is_hung[static_cast<std::size_t>(entity)]) values->push_back(hung_line_value(problem, entity));
  return json_array(std::move(*values));
}

/// Where the instance has what no certificate states; nothing where it has nothing of the kind.
const char* beyond_certificates(const ProblemStatement& problem) {
  if (!problem.bodies.empty()) return "/bodies";
  if (problem.dimension == 2 && !problem.lines.empty()) return "/lines";
  if (problem.file_frame) return "/fixed";
  for (int entity = static_cast<int>(problem.points.size()); entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity)) return "/fixed";
  for (const Relation& relation : problem.relations)
    if (!is_certifiable(problem, relation)) return "/constraints";
  const Reference reference = Scene::unchecked(problem).reference();
  const bool is_of_points = std::ranges::all_of(
      std::array{reference.origin, reference.axis, problem.dimension == 2 ? reference.axis : reference.plane},
      [&](int entity) { return entity >= 0 && problem.is_point(entity); });
  const bool has_line = !problem.is_general() && reference.line >= 0;
  return is_of_points || has_line || problem.has_fixed() ? nullptr : "/reference";
}

std::vector<ProvenFigure> proven_figures(const Scene& scene, const Answer& answer) {
  std::vector<Figure> certified;
  for (const AssessedSolution& solution : answer.solutions)
    if (solution.certified) certified.push_back(solution.figure);
  const auto boxes = dyadic_figures(SceneEquations(scene), scene, certified, answer.threads);
  std::vector<ProvenFigure> proven;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i]) proven.push_back({*boxes[i], certified[i].is_real()});
  return proven;
}

}  // namespace

void require_certifiable(const Instance& instance) {
  const char* place = beyond_certificates(instance.problem);
  if (place == nullptr) return;
  throw InputError(
      instance.origin, place,
      "a certificate is of points, lines and planes in space with distances from points and cosines "
      "between planes, in a frame of points, of a line and a point, or of given points that leave no motion",
      "leave out --certificate; --certify proves more");
}

std::size_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                              const TextSink& take) {
  const std::vector<ProvenFigure> proven = proven_figures(scene, answer);
  const auto real =
      std::count_if(proven.begin(), proven.end(), [](const ProvenFigure& p) { return p.is_real; });
  DocumentWriter document("gcsbench-certificate/1", take, answer.threads);
  document.member("instance", instance.document);
  document.member("frame", frame_value(scene));
  document.member("unit", json_number(scene.unit_exponent()));
  document.member("complex", json_count(proven.size()));
  document.member("real", json_count(static_cast<std::uint64_t>(real)));
  document.member("limit", limit_value(scene));
  document.list("solutions", proven, [](const ProvenFigure& p) { return solution_value(p); });
  document.member("at_infinity", at_infinity_value(scene, answer));
  document.end();
  return proven.size();
}

}  // namespace gcs
