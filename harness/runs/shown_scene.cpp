#include "harness/runs/shown_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

constexpr std::string_view format_name = "gcsbench-scene/1";

// ---- writing

JsonValue solution_value(const ProblemStatement& problem, const ShownSolution& solution) {
  JsonMembers members{{"multiplicity", json_number(solution.multiplicity)},
                      {"points", json_points(problem, solution.figure)},
                      {"lines", json_lines(problem, solution.figure)}};
  if (!problem.planes.empty()) members.emplace_back("planes", json_planes(problem, solution.figure));
  return json_object(std::move(members));
}

JsonValue crossing_value(const std::optional<MetSolution>& met) {
  return json_or_null(met, [](const MetSolution& m) {
    return json_object(
        {{"solution", json_number(m.solution)}, {"signs", json_array_of(m.signs, json_number)}});
  });
}

JsonValue place_value(const PlanPlace& place) {
  return json_object({{"t", json_number(place.t)},
                      {"length", json_number(place.length)},
                      {"removed", json_texts(place.removed)}});
}

JsonValue trail_value(const PlanTrail& trail) {
  return json_object({{"label", json_text(trail.label)},
                      {"cause", json_text(trail.cause)},
                      {"places", json_array_of(trail.places, place_value)}});
}

template <typename List, typename Make>
std::string lines_of(const List& list, Make make) {
  std::vector<std::string> lines;
  for (const auto& one : list) lines.push_back(to_text(make(one), -1));
  return fmt::format("[{}{}]", lines.empty() ? "" : "\n  ", fmt::join(lines, ",\n  "));
}

// ---- reading

/// A whole number from `low` to `high`.
int read_whole(const JsonCursor& cursor, int low, int high) {
  const double value = cursor.number().value;
  if (!(value >= low && value <= high) || value != static_cast<int>(value))
    cursor.fail(fmt::format("{} is out of place", cursor.number().text),
                fmt::format("give a whole number from {} to {}", low, high));
  return static_cast<int>(value);
}

ShownSolution read_solution(const JsonCursor& cursor, const ProblemStatement& problem) {
  ShownSolution solution;
  solution.multiplicity = read_whole(cursor.required("multiplicity"), 1, 1 << 20);
  solution.figure = read_figure(cursor, problem, true);
  return solution;
}

std::optional<MetSolution> read_crossing(const JsonCursor& cursor, std::size_t solutions) {
  if (cursor.is_null()) return std::nullopt;
  MetSolution met;
  met.solution = read_whole(cursor.required("solution"), 0, static_cast<int>(solutions) - 1);
  const auto signs = cursor.required("signs").elements(3, "signs");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    met.signs[axis] = read_whole(signs[axis], -1, 1);
    if (met.signs[axis] == 0) signs[axis].fail("0 is no sign", "give 1 or -1");
  }
  return met;
}

PlanTrail read_trail(const JsonCursor& cursor) {
  PlanTrail trail{cursor.required("label").text(), {}, cursor.required("cause").text()};
  for (const JsonCursor& entry : cursor.required("places").elements()) {
    PlanPlace place{entry.required("t").number().value, entry.required("length").number().value, {}};
    for (const JsonCursor& name : entry.required("removed").elements()) place.removed.push_back(name.text());
    trail.places.push_back(std::move(place));
  }
  return trail;
}

}  // namespace

std::string to_json_text(const ShownScene& record) {
  const ProblemStatement& problem = record.instance.problem;
  return fmt::format(
      "{{\"format\": \"{}\",\n \"instance\": {},\n \"source\": {},\n \"proven\": {},\n \"all_real\": {}, "
      "\"all_real_proven\": {},\n "
      "\"solutions\": {},\n \"no_path\": {},\n \"crossings\": {},\n \"trails\": {}}}\n",
      format_name, to_text(record.instance.document, -1), to_text(json_text(record.source), -1),
      record.are_proven, record.has_all_real, record.is_real_proven,
      lines_of(record.solutions, [&](const ShownSolution& s) { return solution_value(problem, s); }),
      to_text(json_text(record.no_path), -1), lines_of(record.crossings, crossing_value),
      lines_of(record.trails, trail_value));
}

ShownScene parse_shown_scene(const std::string& text, const std::string& file) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(format_name);
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
  for (const JsonCursor& entry : root.required("trails").elements())
    record.trails.push_back(read_trail(entry));
  return record;
}

}  // namespace gcs
