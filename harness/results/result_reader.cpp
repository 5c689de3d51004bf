#include "harness/results/result_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <utility>

#include "harness/base/record_fields.hpp"
#include "harness/base/record_json.hpp"
#include "harness/results/file_formats.hpp"
#include "solvers/reading/cbor_document.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

/// Whether the first coordinates are numbers: those of a point, or of a line or plane where there are no points.
bool has_real_coordinates(const JsonCursor& solution, const ProblemStatement& problem) {
  const auto first = [&] {
    if (!problem.points.empty()) return solution.required("points").required(problem.points.front());
    if (!problem.lines.empty())
      return solution.required("lines").required(problem.lines.front()).required("point");
    return solution.required("planes").required(problem.planes.front()).required("normal");
  };
  const auto coordinates = first().elements();
  return coordinates.empty() || coordinates.front().value().kind != JsonValue::Kind::array;
}

/// Without "standing" it is as stated.
SignVerdict read_signs(const JsonCursor& solution, const ProblemStatement& problem) {
  SignVerdict signs;
  std::optional<Standing> standing;
  RecordReader(solution).named("standing", standing, all_standings);
  signs.standing = standing.value_or(Standing::as_stated);
  const auto against = solution.optional("against");
  if (!against || against->is_null()) return signs;
  for (const JsonCursor& id : against->elements()) {
    const auto found = std::ranges::find(problem.relations, id.text(), &Relation::id);
    if (found == problem.relations.end())
      id.fail("there is no constraint '" + id.text() + "' without a length",
              "give the id of an orientation or an angle");
    signs.relations.push_back(static_cast<int>(found - problem.relations.begin()));
  }
  return signs;
}

AssessedSolution read_solution(const JsonCursor& cursor, const Scene& scene) {
  AssessedSolution solution;
  const auto real = cursor.optional("real");
  const bool is_real = real ? real->boolean() : has_real_coordinates(cursor, scene.problem());
  solution.figure = scene.in_scene_unit(read_figure(cursor, scene.problem(), is_real));
  const RecordReader read(cursor);
  solution.condition = std::numeric_limits<double>::infinity();
  read.later("multiplicity", solution.multiplicity);
  read.later("condition", solution.condition);
  read.later("error_bound", solution.error_bound);
  if (solution.error_bound) solution.error_bound = std::ldexp(*solution.error_bound, -scene.unit_exponent());
  read.later("certified", solution.certified);
  if (is_real) solution.signs = read_signs(cursor, scene.problem());
  return solution;
}

std::vector<AssessedCrossing> read_crossings(const JsonCursor& path, std::size_t solutions) {
  std::vector<AssessedCrossing> crossings;
  if (path.is_null()) return crossings;
  for (const JsonCursor& element : path.elements()) {
    AssessedCrossing crossing;
    const JsonCursor solution = element.required("solution"), direction = element.required("direction");
    if (!solution.is_null()) {
      read_json(solution, crossing.solution.emplace());
      if (static_cast<std::size_t>(*crossing.solution) >= solutions)
        solution.fail("there is no such solution", fmt::format("give a number below {}, or null", solutions));
    }
    crossing.direction = direction.number().value > 0 ? 1 : -1;
    crossings.push_back(crossing);
  }
  return crossings;
}

/// What a result says of the solve and its solutions, which are appended; only these have to be there.
void read_answer(const JsonCursor& root, const Scene& scene, Answer& answer) {
  const RecordReader read(root);
  const auto status = root.optional("status");
  answer.status = status ? read_word(*status, all_statuses) : RunStatus::complete;
  read.later("reason", answer.reason);
  read.named("claim", answer.claim, all_claims);
  for (const JsonCursor& solution : root.required("solutions").elements())
    answer.solutions.push_back(read_solution(solution, scene));
  if (const auto escaping = root.optional("escaping"))
    for (const JsonCursor& figure : escaping->elements())
      answer.escaping.push_back(read_figure(figure, scene.problem(), false));
  if (const auto path = root.optional("path"))
    answer.crossings = read_crossings(*path, answer.solutions.size());
}

StoredResult empty_result(const JsonCursor& root, const std::string& file) {
  root.require_format(result_format);
  const Instance instance =
      parse_instance(to_text(root.required("instance").value(), -1), file + " (instance)");
  return {.instance = instance, .scene = instance};
}

JsonCursor solution_cursor(const JsonValue& solution, const std::string& file, std::size_t number) {
  return {solution, file, "/solutions/" + std::to_string(number)};
}

}  // namespace

std::string read_result(const std::string& argument) {
  return argument == "-" ? read_all(std::cin, argument)
                         : read_file(argument, "give a file that `gcsbench solve --out` has written");
}

Answer parse_answer(const std::string& text, const Scene& scene, const std::string& source) {
  Answer answer;
  const auto take = [&](const JsonValue& known, const JsonValue& solution, std::size_t number) {
    if (number == 0 && known.find("format") != nullptr)
      JsonCursor(known, source).require_format(result_format);
    answer.solutions.push_back(read_solution(solution_cursor(solution, source, number), scene));
    return true;
  };
  const JsonValue document = parse_document(text, source, {"solutions", take});
  const JsonCursor root(document, source);
  if (root.optional("format")) root.require_format(result_format);
  read_answer(root, scene, answer);
  return answer;
}

StoredResult parse_result(const std::string& text, const std::string& file) {
  std::optional<StoredResult> read;
  const auto take = [&](const JsonValue& known, const JsonValue& solution, std::size_t number) {
    if (known.find("format") == nullptr || known.find("instance") == nullptr) return false;
    if (!read) read.emplace(empty_result({known, file}, file));
    read->answer.solutions.push_back(read_solution(solution_cursor(solution, file, number), read->scene));
    return true;
  };
  const JsonValue document = parse_document(text, file, {"solutions", take});
  const JsonCursor root(document, file);
  StoredResult result = read ? std::move(*read) : empty_result(root, file);
  const std::string strategy = root.required("strategy").text();
  root.required("status");
  read_answer(root, result.scene, result.answer);
  result.answer.strategy = strategy;
  const auto passed_over = RecordReader::Missing::passed_over;
  if (const auto counts = root.optional("counts"))
    visit_result_counts(result.stated, RecordReader(*counts, passed_over));
  result.answer.counts = counts_of(result.stated);
  if (const auto totals = root.optional("totals"); totals && !totals->is_null())
    visit_totals(result.answer.totals.emplace(), RecordReader(*totals, passed_over));
  return result;
}

StoredResult load_result(const std::string& argument) {
  return parse_result(read_result(argument), argument);
}

}  // namespace gcs
