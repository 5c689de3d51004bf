#include "harness/solving/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "harness/base/complex_rows.hpp"
#include "harness/base/document_text.hpp"
#include "harness/base/record_json.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {

/// What was stopped is not kept.
constexpr std::array kept_ends{SearchEnd::complete, SearchEnd::quiet, SearchEnd::inconsistent};

std::string_view word(SearchEnd end) {
  constexpr std::array<std::string_view, 4> words{"complete", "quiet", "inconsistent", "stopped"};
  return words[static_cast<std::size_t>(end)];
}

void visit_fields(RecordOf<GenericSolutions> auto& generic, const auto& visit) {
  visit.named("end", generic.end, kept_ends);
  visit("arcs", generic.arcs_used);
  visit("paths", generic.legs);
  visit("lost_paths", generic.lost_legs);
}

void visit_fields(RecordOf<TraceTest> auto& trace, const auto& visit) {
  visit.named("end", trace.end, kept_ends);
  visit("points", trace.points);
  visit("solutions", trace.solutions);
  visit("defect", trace.defect);
}

namespace {

constexpr std::string_view format_name = "gcsbench-start/1";
constexpr std::string_view remedy = "make it anew with --set save_start=FILE";

JsonValue search_value(const GenericSolutions& generic) {
  JsonValue value = json_of(generic);
  value.members.emplace_back("solutions", json_count(generic.solutions.size()));
  return value;
}

std::string file_text(const StartFamily& family, const StartSystem& start) {
  return document_text(format_name, [&](DocumentWriter& document) {
    document.list("equations", family.equations, json_text);
    document.member("search", search_value(start.generic));
    document.member("trace", json_of(start.trace));
    document.member("squares", json_array_of(start.generic.squares, json_complex));
    document.list("solutions", start.generic.solutions,
                  [](const ComplexVectorX& solution) { return json_array_of(solution, json_complex); });
  });
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

GenericSolutions read_search(const JsonCursor& search) {
  search.allow_members({"end", "solutions", "arcs", "paths", "lost_paths"});
  GenericSolutions generic;
  read_json(search, generic);
  return generic;
}

std::optional<TraceTest> read_trace(const JsonCursor& trace) {
  if (!trace.is_null()) trace.allow_members({"end", "points", "solutions", "defect"});
  std::optional<TraceTest> test;
  read_json(trace, test);
  return test;
}

void require_solutions(const JsonCursor& document, const std::string& file, const StartFamily& family,
                       const GenericSolutions& generic) {
  const JsonCursor solutions = document.required("solutions"),
                   count = document.required("search").required("solutions");
  std::uint64_t found = 0;
  read_json(count, found);
  if (found != generic.solutions.size())
    solutions.fail(
        fmt::format("there are {} solutions, and the search found {}", generic.solutions.size(), found),
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
