/// Every cell of a run with its repetitions.

#include <fmt/format.h>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

double median_of(const std::vector<Timing>& repetitions, double Timing::*part) {
  std::vector<double> seconds;
  for (const Timing& repetition : repetitions) seconds.push_back(repetition.*part);
  return median_interval(std::move(seconds)).median;
}

std::vector<TableCell> timing_entries(const CellRecord& cell) {
  const auto time = total_time(&cell);
  if (!time) return std::vector<TableCell>(6, empty_entry());
  return {{duration_text(time->median), {}},
          {duration_text(time->low), {}},
          {duration_text(time->high), {}},
          {fmt::format("{:.3g}%", 100 * time->confidence), {}},
          {duration_text(median_of(cell.repetitions, &Timing::prepare_s)), {}},
          {duration_text(median_of(cell.repetitions, &Timing::wall_s)), {}}};
}

TableCell verdict_entry(Table& table, const CellRecord& cell) {
  if (cell.is_right()) return {"right", {}};
  const bool complete = cell.status == RunStatus::complete;
  return {complete ? "wrong" : std::string(word(cell.status)),
          {table.footnote(complete ? cell.flaw() : cell.reason)}};
}

}  // namespace

Table build_measurements(const RunFile& run) {
  Table table;
  table.name = "measurements";
  table.caption = "Every measurement";
  table.stub = "instance, strategy";
  table.groups = {{"answer", {"verdict", "on S", "largest residual"}},
                  {"prepare and solve", {"runs", "median", "from", "to", "confidence"}},
                  {"medians", {"prepare", "solve"}}};
  for (const CellRecord& cell : run.cells) {
    TableRow row{fmt::format("{}, {}", cell.spec.instance, label_of(cell.spec)), {}, {}};
    row.cells = {verdict_entry(table, cell),
                 on_path(&cell) ? TableCell{number_text(*on_path(&cell)), {}} : empty_entry(),
                 {fmt::format("{:.1e}", cell.residual), {}},
                 {std::to_string(cell.repetitions.size()), {}}};
    for (TableCell& entry : timing_entries(cell)) row.cells.push_back(std::move(entry));
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      "On S: solutions on the path, up to reflection. Largest residual: of a length, relative to it.",
      fmt::format(
          "Interval of the median by order statistics, whatever the distribution; with fewer than 6 runs "
          "their whole range. Seed {}, {} thread(s).",
          run.seed, run.environment.threads),
      fmt::format("{}; {}; {}; commit {}; started {}.", run.environment.cpu, run.environment.compiler,
                  run.environment.flags, run.environment.commit, run.started)};
  return table;
}

}  // namespace gcs
