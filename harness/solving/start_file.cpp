#include "harness/solving/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "harness/base/complex_rows.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {

namespace {

constexpr std::string_view format_name = "gcsbench-start/1";
constexpr std::string_view remedy = "make it anew with --set save_start=FILE";

/// In the order of SearchEnd. What was stopped is not kept.
constexpr std::array<std::string_view, 3> end_words{"complete", "quiet", "inconsistent"};

JsonValue end_value(SearchEnd end) {
  return json_text(std::string(end_words[static_cast<std::size_t>(end)]));
}

JsonValue search_value(const GenericSolutions& generic) {
  return json_object({{"end", end_value(generic.end)},
                      {"solutions", json_count(generic.solutions.size())},
                      {"arcs", json_number(generic.arcs_used)},
                      {"paths", json_count(static_cast<std::uint64_t>(generic.legs))},
                      {"lost_paths", json_count(static_cast<std::uint64_t>(generic.lost_legs))}});
}

JsonValue trace_value(const TraceTest& trace) {
  return json_object({{"end", end_value(trace.end)},
                      {"points", json_count(static_cast<std::uint64_t>(trace.points))},
                      {"solutions", json_count(static_cast<std::uint64_t>(trace.solutions))},
                      {"defect", json_number(trace.defect)}});
}

/// One solution a line.
std::string solutions_text(const std::vector<ComplexVectorX>& solutions) {
  std::vector<std::string> lines;
  for (const ComplexVectorX& x : solutions) lines.push_back(to_text(json_array_of(x, json_complex), -1));
  return fmt::format("[\n  {}\n ]", fmt::join(lines, ",\n  "));
}

std::string file_text(const StartFamily& family, const StartSystem& start) {
  return fmt::format(
      "{{\"format\": \"{}\",\n \"equations\": {},\n \"search\": {},\n \"trace\": {},\n \"squares\": {},\n "
      "\"solutions\": {}}}\n",
      format_name, to_text(json_texts(family.equations), 2), to_text(search_value(start.generic), -1),
      to_text(json_or_null(start.trace, trace_value), -1),
      to_text(json_array_of(start.generic.squares, json_complex), -1),
      solutions_text(start.generic.solutions));
}

void require_equations(const JsonCursor& equations, const StartFamily& family) {
  const std::string own =
      "a start system serves the graph and frame that it was made for; "
      "make one for this scene with --set save_start=FILE";
  const std::vector<std::string>& wanted = family.equations;
  const std::vector<JsonCursor> given = equations.elements();
  for (std::size_t e = 0; e < std::min(given.size(), wanted.size()); ++e)
    if (given[e].text() != wanted[e])
      given[e].fail(fmt::format("the equation is {}, and here {}", given[e].text(), wanted[e]), own);
  if (given.size() != wanted.size())
    equations.fail(fmt::format("there are {} equations, and here {}", given.size(), wanted.size()), own);
}

ComplexVectorX read_vector(const JsonCursor& vector, int size) {
  ComplexVectorX x;
  for (const JsonCursor& number : vector.elements(static_cast<std::size_t>(size), "complex numbers [re, im]"))
    x.push_back(read_complex(number));
  return x;
}

std::vector<ComplexVectorX> read_vectors(const JsonCursor& vectors, int size) {
  std::vector<ComplexVectorX> result;
  for (const JsonCursor& vector : vectors.elements()) result.push_back(read_vector(vector, size));
  return result;
}

SearchEnd read_end(const JsonCursor& end) {
  const std::string word = end.text();
  const auto known = std::find(end_words.begin(), end_words.end(), word);
  if (known == end_words.end())
    end.fail_unknown("there is no end '" + word + "' of a search", word,
                     {end_words.begin(), end_words.end()});
  return static_cast<SearchEnd>(known - end_words.begin());
}

std::int64_t read_count(const JsonCursor& count) {
  constexpr double largest = 9007199254740992;  // 2^53
  const double value = count.number().value;
  if (!(value >= 0 && value <= largest && value == std::floor(value)))
    count.fail("this is no count", "give a whole number that is not negative");
  return static_cast<std::int64_t>(value);
}

GenericSolutions read_search(const JsonCursor& search) {
  search.allow_members({"end", "solutions", "arcs", "paths", "lost_paths"});
  GenericSolutions generic;
  generic.end = read_end(search.required("end"));
  generic.arcs_used = static_cast<int>(read_count(search.required("arcs")));
  generic.legs = read_count(search.required("paths"));
  generic.lost_legs = read_count(search.required("lost_paths"));
  return generic;
}

std::optional<TraceTest> read_trace(const JsonCursor& trace) {
  if (trace.is_null()) return std::nullopt;
  trace.allow_members({"end", "points", "solutions", "defect"});
  return TraceTest{read_end(trace.required("end")), read_count(trace.required("points")),
                   read_count(trace.required("solutions")), trace.required("defect").number().value};
}

void require_solutions(const JsonCursor& document, const std::string& file, const StartFamily& family,
                       const GenericSolutions& generic) {
  const JsonCursor solutions = document.required("solutions"),
                   count = document.required("search").required("solutions");
  if (read_count(count) != static_cast<std::int64_t>(generic.solutions.size()))
    solutions.fail(fmt::format("there are {} solutions, and the search found {}", generic.solutions.size(),
                               count.number().text),
                   "some are missing or too many: " + std::string(remedy));
  if (const auto defect = find_defect(family, generic))
    throw InputError(file, fmt::format("{}/{}", solutions.pointer(), defect->solution), defect->what,
                     std::string(remedy));
}

/// `solutions`: where they are known already, and the document has an empty list in their place.
StartSystem read_start(const JsonCursor& document, const std::string& file, const StartFamily& family,
                       std::vector<ComplexVectorX> solutions) {
  document.require_format(format_name);
  document.allow_members({"format", "equations", "search", "trace", "squares", "solutions"});
  require_equations(document.required("equations"), family);
  StartSystem start{read_search(document.required("search")), read_trace(document.required("trace"))};
  start.generic.squares = read_vector(document.required("squares"), family.parameters);
  start.generic.solutions = std::move(solutions);
  if (start.generic.solutions.empty())
    start.generic.solutions = read_vectors(document.required("solutions"), family.unknowns);
  require_solutions(document, file, family, start.generic);
  return start;
}

bool has_no_solutions(const JsonValue& document) {
  const JsonValue* solutions =
      document.kind == JsonValue::Kind::object ? document.find("solutions") : nullptr;
  return solutions && solutions->kind == JsonValue::Kind::array && solutions->elements.empty();
}

}  // namespace

StartSystem StartFiles::read(const std::string& name, const StartFamily& family) const {
  const std::string text = read_file(name, "give a file that save_start has written");
  if (std::optional<ComplexRows> taken = take_complex_rows(text, "solutions", family.unknowns)) {
    const JsonValue document = parse_json(taken->rest, name);
    // Otherwise the rows were taken from another place than the solutions'.
    if (has_no_solutions(document))
      return read_start(JsonCursor(document, name), name, family, std::move(taken->rows));
  }
  const JsonValue document = parse_json(text, name);
  return read_start(JsonCursor(document, name), name, family, {});
}

void StartFiles::reserve(const std::string& name) { reserved_[name] = std::make_unique<AtomicFile>(name); }

void StartFiles::write(const std::string& name, const StartFamily& family, const StartSystem& start) {
  const auto file = reserved_.extract(name);
  file.mapped()->commit(file_text(family, start));
}

}  // namespace gcs
