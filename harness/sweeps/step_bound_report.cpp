#include "harness/sweeps/step_bound_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "harness/sweeps/sweep_main.hpp"
#include "harness/tables/table_writer.hpp"

namespace gcs {
namespace {

using Scenes = std::vector<const SweptScene*>;

std::string counted(const Scenes& scenes, bool (*is_counted)(const StepBoundVerdict&)) {
  return std::to_string(std::count_if(scenes.begin(), scenes.end(),
                                      [=](const SweptScene* s) { return is_counted(s->verdict); }));
}

/// How many scenes have none; least, median and largest number.
std::vector<std::string> spread_of_solutions(const Scenes& scenes) {
  std::vector<std::size_t> counts;
  for (const SweptScene* scene : scenes) counts.push_back(scene->verdict.solutions);
  std::sort(counts.begin(), counts.end());
  const double median = static_cast<double>(counts[(counts.size() - 1) / 2] + counts[counts.size() / 2]) / 2;
  const auto none = std::count(counts.begin(), counts.end(), std::size_t{0});
  return {std::to_string(none), std::to_string(counts.front()), fmt::format("{}", median),
          std::to_string(counts.back())};
}

/// Accepted steps of each strategy at each bound, all scenes together.
std::vector<std::string> steps(const Scenes& scenes) {
  std::vector<std::int64_t> sums(scenes.front()->verdict.runs.size());
  for (const SweptScene* scene : scenes)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += scene->verdict.runs[i].report.work.iterations;
  std::vector<std::string> texts(sums.size());
  std::transform(sums.begin(), sums.end(), texts.begin(),
                 [](std::int64_t sum) { return std::to_string(sum); });
  return texts;
}

TableRow row(const std::string& label, const Scenes& scenes) {
  std::vector<std::string> texts{std::to_string(scenes.size())};
  for (const std::string& text : spread_of_solutions(scenes)) texts.push_back(text);
  texts.push_back(counted(scenes, [](const StepBoundVerdict& v) { return v.agrees(); }));
  texts.push_back(counted(scenes, [](const StepBoundVerdict& v) { return !v.differences.empty(); }));
  texts.push_back(counted(scenes, [](const StepBoundVerdict& v) { return !v.unfinished.empty(); }));
  for (const std::string& text : steps(scenes)) texts.push_back(text);
  TableRow result{label, {}, {}};
  for (const std::string& text : texts) result.cells.push_back({text, {}});
  return result;
}

Table empty_table(const SweptScene& scene, const SweepHeader& header) {
  Table table;
  table.caption = "Scenes by kind";
  table.stub = "Scenes";
  table.groups = {{"Number", {""}},
                  {"Solutions on S", {"scenes without", "least", "median", "most"}},
                  {"Scenes that", {"agree", "disagree", "gave up"}}};
  for (std::size_t i = 0; i < scene.verdict.runs.size(); i += header.bounds.size()) {
    ColumnGroup group{"Steps of " + scene.verdict.runs[i].strategy, {}};
    for (const StepBound& bound : header.bounds) group.columns.push_back(bound.name);
    table.groups.push_back(group);
  }
  return table;
}

std::string kind_table(std::span<const SweptScene> scenes, const SweepHeader& header) {
  Table table = empty_table(scenes.front(), header);
  std::map<std::pair<int, int>, Scenes> kinds;
  Scenes all;
  for (const SweptScene& scene : scenes) {
    kinds[{scene.kind.dimension, scene.kind.points}].push_back(&scene);
    all.push_back(&scene);
  }
  for (const auto& [kind, members] : kinds)
    table.rows.push_back(
        row(fmt::format("{}, {} points", kind.first == 2 ? "plane" : "space", kind.second), members));
  table.rows.push_back(row("all", all));
  return to_markdown(table);
}

std::string options_line(const StepBoundVerdict& verdict) {
  std::string line;
  for (const BoundedRun& run : verdict.runs) {
    line += fmt::format("- {}, {}:", run.strategy, run.bound);
    for (const auto& [name, value] : run.options) line += fmt::format(" {}={}", name, value);
    line += "\n";
  }
  return line;
}

std::string failures(std::span<const SweptScene> scenes) {
  std::string text;
  for (const SweptScene& scene : scenes) {
    if (scene.verdict.agrees()) continue;
    text += fmt::format("- seed {} ({}D, {} points, {} solutions):\n", scene.seed, scene.kind.dimension,
                        scene.kind.points, scene.verdict.solutions);
    for (const std::string& sentence : scene.verdict.unfinished) text += "  - " + sentence + "\n";
    for (const std::string& sentence : scene.verdict.differences) text += "  - " + sentence + "\n";
  }
  return text.empty() ? "None.\n" : text;
}

}  // namespace

std::string step_bound_report(const SweepHeader& header, std::span<const SweptScene> scenes) {
  return fmt::format(
      "# Solutions on S and the bound of the steps\n\n"
      "Random rigid graphs with random sketch and target, seeds {} to {}. Each strategy runs with its "
      "default "
      "options and with smaller steps; all runs must find the same solutions in the same order around S. A "
      "scene "
      "that gave up is counted there and, where its other runs differ, as a disagreement too. Written by "
      "`scripts/sweep-step-bound`.\n\n"
      "{}, {:.0f} s.\n\n{}\n"
      "## Scenes that disagree or gave up\n\n{}\n## Options\n\n{}",
      header.first_seed, header.first_seed + scenes.size() - 1, where_measured(), header.total_s,
      kind_table(scenes, header), failures(scenes), options_line(scenes.front().verdict));
}

}  // namespace gcs
