#include "harness/runs/published.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "harness/base/record_json.hpp"
#include "harness/base/shipped_data.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

constexpr std::string_view published_format = "gcsbench-published/1";

}  // namespace

// ---- what the file says of each record

void visit_fields(RecordOf<Correction> auto& correction, const auto& visit) {
  visit("reason", correction.reason);
  visit("source", correction.source);
  visit.later("proof", correction.is_proof);
}

void read_json(const JsonCursor& cursor, std::vector<PrintedPoint>& points) {
  for (const auto& [name, coordinates] : cursor.members())
    read_json(coordinates, points.emplace_back(PrintedPoint{name, {}}).printed);
}

void read_json(const JsonCursor& cursor, PrintedSolution& solution) {
  const RecordReader read(cursor);
  read("place", solution.place);
  read("instance", solution.instance);
  read("number", solution.number);
  read("points", solution.points);
  read.later("correction", solution.correction);
  if (solution.correction) read_json(cursor.required("correction").required("points"), solution.corrected);
}

void visit_fields(RecordOf<PrintedFigure> auto& figure, const auto& visit) {
  visit("place", figure.place);
  visit("row", figure.row);
  visit("instance", figure.instance);
  visit("value", figure.value);
  visit("printed", figure.printed);
  visit.later("by", figure.by);
  visit.later("convention", figure.convention);
  visit.later("remark", figure.remark);
  visit.later("chosen", figure.chosen);
  visit.later("at_least", figure.at_least);
  visit.later("correction", figure.correction);
}

void visit_fields(RecordOf<Publication> auto& publication, const auto& visit) {
  visit("source", publication.source);
  visit("citation", publication.citation);
  visit("machine", publication.machine);
  visit("instances", publication.instance_remarks);
  visit("figures", publication.figures);
  visit.later("solutions", publication.solutions);
}

const PrintedFigure* Publication::find(const std::string& place, const std::string& row,
                                       const std::string& instance, const std::string& by) const {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const PrintedFigure& f) {
    return f.place == place && f.row == row && f.instance == instance && f.by == by;
  });
  return found == figures.end() ? nullptr : &*found;
}

Publication parse_publication(const std::string& text, const std::string& file) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(published_format);
  Publication publication;
  read_json(root, publication);
  return publication;
}

Publication load_publication(const std::string& source) {
  const std::filesystem::path below = std::filesystem::path("results") / "published" / (source + ".json");
  const std::string file = shipped_file(below).value_or(below).string();
  return parse_publication(read_file(file, "run the program in the source folder, or install it"), file);
}

}  // namespace gcs
