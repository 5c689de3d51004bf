#include "harness/results/result_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>

#include "harness/base/record_fields.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

constexpr std::string_view format_name = "gcsbench-result/1";

void read_count(const JsonCursor& cursor, Natural& count) {
  const bool is_text = cursor.value().kind == JsonValue::Kind::string;
  const std::string text = is_text ? cursor.text() : cursor.number().text;
  const auto value = Natural::from_decimal(text);
  if (!value) cursor.fail("'" + text + "' is no count", "give a whole number that is not negative");
  count = *value;
}

/// One that numbers or measures what a file holds.
void read_count(const JsonCursor& cursor, std::uint64_t& count) {
  Natural value;
  read_count(cursor, value);
  const std::string text = value.decimal();
  if (std::from_chars(text.data(), text.data() + text.size(), count).ec != std::errc())
    cursor.fail("'" + text + "' is too large", "give a whole number below 2^64");
}

int read_number(const JsonCursor& cursor) {
  constexpr int most = std::numeric_limits<int>::max();
  std::uint64_t count = 0;
  read_count(cursor, count);
  if (count > most)
    cursor.fail("'" + cursor.number().text + "' is too large", fmt::format("give a number up to {}", most));
  return static_cast<int>(count);
}

/// The one of `all` whose word the value is.
template <typename Named, std::size_t count>
Named read_word(const JsonCursor& cursor, const std::array<Named, count>& all) {
  const std::string text = cursor.text();
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](Named one) { return word(one) == text; });
  if (found != all.end()) return *found;
  std::vector<std::string> words;
  for (const Named one : all) words.emplace_back(word(one));
  cursor.fail("'" + text + "' is no known word", "give one of " + quoted_list(words));
}

/// Nothing where there is none, or null.
std::optional<Claim> read_claim(const JsonCursor& root) {
  const auto claim = root.optional("claim");
  return claim && !claim->is_null() ? std::optional(read_word(*claim, all_claims)) : std::nullopt;
}

/// Whether the coordinates of the first point are numbers.
bool has_real_points(const JsonCursor& points, const ProblemStatement& problem) {
  const auto coordinates = points.required(problem.points.front()).elements();
  return coordinates.empty() || coordinates.front().value().kind != JsonValue::Kind::array;
}

AssessedSolution read_solution(const JsonCursor& cursor, const Scene& scene) {
  AssessedSolution solution;
  const JsonCursor points = cursor.required("points");
  const auto real = cursor.optional("real");
  const bool is_real = real ? real->boolean() : has_real_points(points, scene.problem());
  solution.figure = scene.in_scene_unit(read_figure(cursor, scene.problem(), is_real));
  if (const auto multiplicity = cursor.optional("multiplicity"))
    solution.multiplicity = read_number(*multiplicity);
  const auto condition = cursor.optional("condition");
  const bool has_condition = condition && !condition->is_null();
  solution.condition = has_condition ? condition->number().value : std::numeric_limits<double>::infinity();
  const auto bound = cursor.optional("error_bound");
  if (bound && !bound->is_null())
    solution.error_bound = std::ldexp(bound->number().value, -scene.unit_exponent());
  if (const auto certified = cursor.optional("certified")) solution.certified = certified->boolean();
  return solution;
}

std::vector<AssessedCrossing> read_crossings(const JsonCursor& path, std::size_t solutions) {
  std::vector<AssessedCrossing> crossings;
  if (path.is_null()) return crossings;
  for (const JsonCursor& element : path.elements()) {
    AssessedCrossing crossing;
    const JsonCursor solution = element.required("solution"), direction = element.required("direction");
    if (!solution.is_null()) {
      crossing.solution = read_number(solution);
      if (static_cast<std::size_t>(*crossing.solution) >= solutions)
        solution.fail("there is no such solution", fmt::format("give a number below {}, or null", solutions));
    }
    crossing.direction = direction.number().value > 0 ? 1 : -1;
    crossings.push_back(crossing);
  }
  return crossings;
}

/// Reads the counts that a list of fields visits; null and what is missing stay empty.
auto count_reader(const JsonCursor& cursor) {
  return [cursor](const std::string& name, auto& count) {
    const auto given = cursor.optional(name);
    if (given && !given->is_null()) read_count(*given, count.emplace());
  };
}

}  // namespace

ProgramAnswer parse_answer(const std::string& text, const Scene& scene, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  const JsonCursor root(document, source);
  if (root.optional("format")) root.require_format(format_name);
  ProgramAnswer answer;
  if (const auto status = root.optional("status")) answer.status = read_word(*status, all_statuses);
  if (const auto reason = root.optional("reason")) answer.reason = reason->text();
  answer.claim = read_claim(root).value_or(answer.claim);
  for (const JsonCursor& solution : root.required("solutions").elements())
    answer.solutions.push_back(read_solution(solution, scene));
  if (const auto path = root.optional("path"))
    answer.crossings = read_crossings(*path, answer.solutions.size());
  return answer;
}

StoredResult parse_result(const std::string& text, const std::string& file) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(format_name);
  Instance instance =
      parse_instance(to_text(root.required("instance").value(), -1), file + " (instance)", "");
  StoredResult result{.instance = instance, .scene = Scene(std::move(instance.problem))};
  result.strategy = root.required("strategy").text();
  result.status = read_word(root.required("status"), all_statuses);
  result.claim = read_claim(root);
  for (const JsonCursor& solution : root.required("solutions").elements())
    result.listed.solutions.push_back(read_solution(solution, result.scene));
  if (const auto path = root.optional("path"))
    result.listed.crossings = read_crossings(*path, result.listed.solutions.size());
  if (const auto counts = root.optional("counts")) visit_counts(result.listed.counts, count_reader(*counts));
  if (const auto totals = root.optional("totals"); totals && !totals->is_null())
    visit_totals(result.listed.totals.emplace(), count_reader(*totals));
  return result;
}

StoredResult load_result(const std::string& argument) {
  const std::string text = argument == "-"
                               ? read_all(std::cin, argument)
                               : read_file(argument, "give a file that `gcsbench solve --out` has written");
  return parse_result(text, argument);
}

}  // namespace gcs
