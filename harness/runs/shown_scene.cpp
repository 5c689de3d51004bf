#include "harness/runs/shown_scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "harness/base/document_text.hpp"
#include "harness/base/record_json.hpp"
#include "solvers/reading/figure_json.hpp"

namespace gcs {

void visit_fields(RecordOf<PlanPlace> auto& place, const auto& visit) {
  visit("t", place.t);
  visit("length", place.length);
  visit("removed", place.removed);
}

void visit_fields(RecordOf<PlanTrail> auto& trail, const auto& visit) {
  visit("label", trail.label);
  visit("cause", trail.cause);
  visit("places", trail.places);
}

namespace {

constexpr std::string_view scene_format = "gcsbench-scene/1";

// ---- writing

JsonMembers figure_members(const ProblemStatement& problem, const Figure& figure) {
  JsonMembers members{{"points", json_points(problem, figure)}, {"lines", json_lines(problem, figure)}};
  if (!problem.planes.empty()) members.emplace_back("planes", json_planes(problem, figure));
  return members;
}

JsonValue solution_value(const ProblemStatement& problem, const ShownSolution& solution) {
  JsonMembers members = figure_members(problem, solution.figure);
  members.emplace(members.begin(), "multiplicity", json_number(solution.multiplicity));
  return json_object(std::move(members));
}

JsonValue curve_value(const ProblemStatement& problem, const ShownCurve& curve) {
  const auto figure = [&](const Figure& one) { return json_object(figure_members(problem, one)); };
  return json_object({{"label", json_text(curve.label)},
                      {"constraint", json_text(curve.constraint)},
                      {"from", json_of(curve.from)},
                      {"to", json_of(curve.to)},
                      {"figures", json_array_of(curve.figures, figure)}});
}

JsonValue crossing_value(const std::optional<MetSolution>& met) {
  return json_or_null(met, [](const MetSolution& m) {
    return json_object({{"solution", json_of(m.solution)}, {"signs", json_of(m.signs)}});
  });
}

// ---- reading

ShownSolution read_solution(const JsonCursor& cursor, const ProblemStatement& problem) {
  ShownSolution solution;
  read_json(cursor.required("multiplicity"), solution.multiplicity);
  solution.figure = read_figure(cursor, problem, true);
  return solution;
}

ShownCurve read_curve(const JsonCursor& cursor, const ShownScene& record) {
  ShownCurve curve{cursor.required("label").text(), cursor.required("constraint").text(), {}, {}, {}};
  const auto read_end = [&](const char* name, std::optional<int>& solution) {
    const JsonCursor end = cursor.required(name);
    read_json(end, solution);
    if (solution && (*solution < 0 || static_cast<std::size_t>(*solution) >= record.solutions.size()))
      end.fail("there is no such solution", fmt::format("give a number below {}", record.solutions.size()));
  };
  read_end("from", curve.from);
  read_end("to", curve.to);
  const JsonCursor figures = cursor.required("figures");
  for (const JsonCursor& figure : figures.elements())
    curve.figures.push_back(read_figure(figure, record.instance.problem, true));
  if (curve.figures.size() < 2) figures.fail("this is no curve", "give two figures at least");
  return curve;
}

int read_sign(const JsonCursor& cursor) {
  const double sign = cursor.number().value;
  if (std::abs(sign) != 1) cursor.fail(cursor.number().text + " is no sign", "give 1 or -1");
  return sign > 0 ? 1 : -1;
}

std::optional<MetSolution> read_crossing(const JsonCursor& cursor, std::size_t solutions) {
  if (cursor.is_null()) return std::nullopt;
  MetSolution met;
  const JsonCursor solution = cursor.required("solution");
  read_json(solution, met.solution);
  if (static_cast<std::size_t>(met.solution) >= solutions)
    solution.fail("there is no such solution", fmt::format("give a number below {}", solutions));
  const auto signs = cursor.required("signs").elements(met.signs.size(), "signs");
  for (std::size_t axis = 0; axis < met.signs.size(); ++axis) met.signs[axis] = read_sign(signs[axis]);
  return met;
}

}  // namespace

std::string to_json_text(const ShownScene& record) {
  const ProblemStatement& problem = record.instance.problem;
  return document_text(scene_format, [&](DocumentWriter& document) {
    document.member("instance", record.instance.document);
    document.member("source", json_text(record.source));
    document.member("proven", json_boolean(record.are_proven));
    document.member("all_real", json_boolean(record.has_all_real));
    document.member("all_real_proven", json_boolean(record.is_real_proven));
    document.list("solutions", record.solutions,
                  [&](const ShownSolution& solution) { return solution_value(problem, solution); });
    document.member("no_path", json_text(record.no_path));
    document.list("crossings", record.crossings, crossing_value);
    document.member("trails", json_of(record.trails));
    document.list("curves", record.curves,
                  [&](const ShownCurve& curve) { return curve_value(problem, curve); });
  });
}

ShownScene parse_shown_scene(const std::string& text, const std::string& file) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(scene_format);
  ShownScene record;
  record.instance = parse_instance(to_text(root.required("instance").value(), -1), file + " (instance)");
  record.source = root.required("source").text();
  record.are_proven = root.required("proven").boolean();
  record.has_all_real = root.required("all_real").boolean();
  if (const auto proven = root.optional("all_real_proven")) record.is_real_proven = proven->boolean();
  record.no_path = root.required("no_path").text();
  for (const JsonCursor& entry : root.required("solutions").elements())
    record.solutions.push_back(read_solution(entry, record.instance.problem));
  for (const JsonCursor& entry : root.required("crossings").elements())
    record.crossings.push_back(read_crossing(entry, record.solutions.size()));
  read_json(root.required("trails"), record.trails);
  if (const auto curves = root.optional("curves"))  // files of earlier versions have none
    for (const JsonCursor& entry : curves->elements()) record.curves.push_back(read_curve(entry, record));
  return record;
}

}  // namespace gcs
