#include "harness/runs/published.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "harness/base/shipped_data.hpp"
#include "solvers/reading/json_document.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

using Json = nlohmann::json;

constexpr const char* format_name = "gcsbench-published/1";

std::optional<Correction> correction_of(const Json& json) {
  if (!json.contains("correction")) return std::nullopt;
  const Json& correction = json["correction"];
  return Correction{correction.at("reason").get<std::string>(), correction.at("source").get<std::string>(),
                    correction.value("proof", true)};
}

std::vector<PrintedPoint> points_of(const Json& json) {
  std::vector<PrintedPoint> points;
  for (const auto& [name, coordinates] : json.items())
    points.push_back({name, coordinates.get<std::array<std::string, 3>>()});
  return points;
}

PrintedSolution solution_of(const Json& json) {
  PrintedSolution solution;
  json.at("place").get_to(solution.place);
  json.at("instance").get_to(solution.instance);
  json.at("number").get_to(solution.number);
  solution.points = points_of(json.at("points"));
  solution.correction = correction_of(json);
  if (solution.correction) solution.corrected = points_of(json["correction"].at("points"));
  return solution;
}

PrintedFigure figure_of(const Json& json) {
  PrintedFigure figure;
  json.at("place").get_to(figure.place);
  json.at("row").get_to(figure.row);
  json.at("instance").get_to(figure.instance);
  json.at("value").get_to(figure.value);
  json.at("printed").get_to(figure.printed);
  figure.by = json.value("by", "");
  figure.convention = json.value("convention", "");
  figure.remark = json.value("remark", "");
  figure.chosen = json.value("chosen", "");
  figure.correction = correction_of(json);
  return figure;
}

Publication publication_of(const Json& json) {
  Publication publication;
  json.at("source").get_to(publication.source);
  json.at("citation").get_to(publication.citation);
  json.at("machine").get_to(publication.machine);
  json.at("instances").get_to(publication.instance_remarks);
  for (const Json& figure : json.at("figures")) publication.figures.push_back(figure_of(figure));
  if (json.contains("solutions"))
    for (const Json& solution : json["solutions"]) publication.solutions.push_back(solution_of(solution));
  return publication;
}

}  // namespace

const PrintedFigure* Publication::find(const std::string& place, const std::string& row,
                                       const std::string& instance, const std::string& by) const {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const PrintedFigure& f) {
    return f.place == place && f.row == row && f.instance == instance && f.by == by;
  });
  return found == figures.end() ? nullptr : &*found;
}

Publication parse_publication(const std::string& text, const std::string& file) {
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format_name) {
      throw InputError(file, "/format", "the format is not the one of published figures",
                       std::string("give a file of format ") + format_name);
    }
    return publication_of(json);
  } catch (const Json::exception& error) {
    throw InputError(file, "", error.what(), "compare with the other files in results/published");
  }
}

Publication load_publication(const std::string& source) {
  const std::filesystem::path below = std::filesystem::path("results") / "published" / (source + ".json");
  const std::string file = shipped_file(below).value_or(below).string();
  return parse_publication(read_file(file, "run the program in the source folder, or install it"), file);
}

}  // namespace gcs
