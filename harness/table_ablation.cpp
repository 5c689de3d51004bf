/// What each part of a strategy is worth: one option changed at a time, against the defaults.

#include <fmt/format.h>

#include "harness/table_entries.hpp"
#include "harness/tables.hpp"

namespace gcs {
namespace {

/// Rows under one heading; the first one is what the others are compared with.
struct Study {
  std::string heading;
  std::vector<Variant> variants;
};

std::vector<Study> studies() {
  const auto rcp = [](OptionMap given) { return Variant{"rcp", std::move(given)}; };
  const auto full = [](OptionMap given) { return Variant{"full-space", std::move(given)}; };
  return {
      {"rcp: changing the plan near boundary configurations",
       {rcp({}), rcp({{"swap", "off"}}), rcp({{"alpha", "0.02"}}), rcp({{"alpha", "0.05"}}),
        rcp({{"alpha", "0.2"}})}},
      {"rcp: order of the series",
       {rcp({}), rcp({{"order", "8"}}), rcp({{"order", "12"}}), rcp({{"order", "24"}})}},
      {"full-space: order of the series",
       {full({}), full({{"order", "8"}}), full({{"order", "12"}}), full({{"order", "24"}})}},
      {"full-space, mode=paper: largest step",
       {full({{"mode", "paper"}}), full({{"mode", "paper"}, {"step_max", "0.05"}}),
        full({{"mode", "paper"}, {"step_max", "0.2"}})}},
      {"rcp, mode=paper: largest step",
       {rcp({{"mode", "paper"}}), rcp({{"mode", "paper"}, {"step_max", "0.025"}}),
        rcp({{"mode", "paper"}, {"step_max", "0.1"}})}},
  };
}

TableCell relative_entry(const CellRecord* cell, const CellRecord* base) {
  const auto time = total_time(cell);
  const auto base_time = total_time(base);
  if (!time || !base_time) return empty_entry();
  return {number_text(time->median / base_time->median), {}};
}

void append_entries(Table& table, TableRow& row, const CellRecord* cell, const CellRecord* base) {
  const auto work = [&](std::int64_t WorkCounters::*counter) {
    return cell == nullptr ? std::nullopt : std::optional(static_cast<double>(cell->work.*counter));
  };
  row.cells.push_back(answer_entry(table, cell, on_path(cell)));
  row.cells.push_back(time_entry(table, cell));
  row.cells.push_back(relative_entry(cell, base));
  row.cells.push_back(answer_entry(table, cell, work(&WorkCounters::iterations)));
  row.cells.push_back(answer_entry(table, cell, work(&WorkCounters::plan_changes)));
}

}  // namespace

std::vector<Variant> ablation_variants() {
  std::vector<Variant> variants;
  for (Study& study : studies()) {
    for (Variant& variant : study.variants) variants.push_back(std::move(variant));
  }
  return variants;
}

std::vector<Table> build_ablation(const RunRecord& run, const Publication&) {
  Table table;
  table.name = "ablation";
  table.caption = "Ablation: one option changed at a time";
  for (const MeasuredInstance& instance : run.instances) {
    table.groups.push_back({instance.id, {"on S", "time", "rel.", "iterations", "plan changes"}});
  }
  for (const Study& study : studies()) {
    table.rows.push_back({study.heading, {}, {}});
    for (const Variant& variant : study.variants) {
      TableRow row{label_of(variant.on("")), {}, {}};
      for (const MeasuredInstance& instance : run.instances) {
        append_entries(table, row, run.find(variant.on(instance.id)),
                       run.find(study.variants.front().on(instance.id)));
      }
      table.rows.push_back(std::move(row));
    }
  }
  table.remarks = {
      defaults_remark,
      "rel.: time relative to the first row of the group. An answer that differs from the strategies' "
      "defaults has no time."};
  return {table};
}

}  // namespace gcs
