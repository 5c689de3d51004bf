/// What each part of a strategy is worth: one option changed at a time, against the defaults.

#include <fmt/format.h>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// Rows under one heading; the first one is what the others are compared with.
struct Study {
  std::string heading;
  std::vector<Variant> variants;
};

/// Scenes of which a part need not be solved for.
const std::vector<std::string>& reducible() {
  static const std::vector<std::string> ids{"octahedron-hung@3", "octahedra@2", "k33-hung@3"};
  return ids;
}

/// Of path strategies, by their solutions on S.
std::vector<Study> path_studies() {
  const auto on_paper = [](std::string strategy, OptionMap given) {
    return Variant{std::move(strategy), std::move(given), {}, reducible()};
  };
  const auto rcp = [&](OptionMap given) { return on_paper("rcp", std::move(given)); };
  const auto full = [&](OptionMap given) { return on_paper("full-space", std::move(given)); };
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

/// With and without what can be left out, by the solutions that the strategy claims.
std::vector<Study> saving_studies() {
  const auto study = [](std::string heading, Variant with, Variant without) {
    return Study{std::move(heading), {std::move(with), std::move(without)}};
  };
  const auto by_option = [&](std::string heading, const std::string& strategy, OptionMap without,
                             const std::vector<std::string>& only_on) {
    return study(std::move(heading), {strategy, {}, only_on}, {strategy, std::move(without), only_on});
  };
  const OptionMap whole{{"reduce", "off"}}, images{{"mirror_images", "followed"}};
  const std::vector<std::string> in_space{"octahedron", "disulfide"};
  return {
      by_option("hung points and parts are solved apart", "monodromy", whole, reducible()),
      by_option("the same, by mixed cells", "polyhedral", whole, reducible()),
      by_option("the same, by subdivision", "plan-scan", whole, reducible()),
      by_option("one of mirror images is followed", "monodromy", images, in_space),
      by_option("the same, by mixed cells", "polyhedral", images, in_space),
      by_option("vector instructions", "monodromy", {{"instructions", "portable"}}, in_space),
      by_option("twice the precision only where paths need it", "monodromy", {{"precision", "twice"}},
                in_space),
      study("proofs and digits only where asked for", {"monodromy", {}, in_space},
            {"monodromy", {}, in_space, {}, 30}),
      study("derivatives from where a parameter matters", {"rcp", {{"mode", "paper"}}, in_space},
            {"rcp", {{"derivatives", "whole"}, {"mode", "paper"}}, in_space}),
      by_option("squared norms as unknowns", "polyhedral", {{"formulation", "coordinates"}}, {"octahedron"}),
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

Table build_paths(const RunFile& run) {
  Table table;
  table.name = "ablation";
  table.caption = "Ablation: one option changed at a time";
  const std::vector<Study> studies = path_studies();
  const Variant& any = studies.front().variants.front();
  for (const InstanceSummary& instance : run.instances)
    if (any.is_for(instance.id))
      table.groups.push_back({instance.id, {"on S", "time", "rel.", "iterations", "plan changes"}});
  for (const Study& study : studies) {
    table.rows.push_back({study.heading, {}, {}});
    for (const Variant& variant : study.variants) {
      TableRow row{label_of(variant.on("")), {}, {}};
      for (const InstanceSummary& instance : run.instances)
        if (variant.is_for(instance.id))
          append_entries(table, row, run.find(variant.on(instance.id)),
                         run.find(study.variants.front().on(instance.id)));
      table.rows.push_back(std::move(row));
    }
  }
  table.remarks = {
      defaults_remark,
      fmt::format(
          "Times: preparing and solving once on one thread, median of interleaved repetitions; {}. rel.: "
          "time relative to the first row of the group. An answer that differs from the strategies' "
          "defaults has no time.",
          spread_remark)};
  return table;
}

/// As many as the strategy claims to find: all complex ones, all real ones, or those on S.
std::optional<double> solutions(const CellRecord* cell) {
  if (cell == nullptr) return std::nullopt;
  if (const auto& count = cell->counts.complex_up_to_reflection) return count->approximate();
  if (const auto& count = cell->counts.real_up_to_reflection) return count->approximate();
  return on_path(cell);
}

/// A row for each instance on which it was measured without.
std::vector<TableRow> saving_rows(Table& table, const RunFile& run, const Study& study) {
  std::vector<TableRow> rows;
  for (const std::string& id : study.variants.front().only_on) {
    const CellRecord* with = run.find(study.variants[0].on(id));
    const CellRecord* without = run.find(study.variants[1].on(id));
    if (without == nullptr) continue;
    rows.push_back({fmt::format("{}, {}", id, label_of(study.variants[1].on(""))),
                    {answer_entry(table, with, solutions(with)), time_entry(table, with),
                     answer_entry(table, without, solutions(without)), time_entry(table, without),
                     relative_entry(without, with)},
                    {}});
  }
  return rows;
}

Table build_savings(const RunFile& run) {
  Table table;
  table.name = "savings";
  table.caption = "What is left out: with and without";
  table.groups = {{"", {"solutions", "with", "solutions", "without", "without / with"}}};
  for (const Study& study : saving_studies()) {
    const std::vector<TableRow> rows = saving_rows(table, run, study);
    if (rows.empty()) continue;
    table.rows.push_back({study.heading, {}, {}});
    table.rows.insert(table.rows.end(), rows.begin(), rows.end());
  }
  table.remarks = {
      "Solutions up to reflection: all complex ones, of plan-scan the real ones, of rcp those on S. Each row "
      "names the option that switches the saving off; digits: every solution is proven and refined to so "
      "many.",
      fmt::format("Times: preparing and solving once on one thread, median of interleaved repetitions; {}.",
                  spread_remark)};
  return table;
}

}  // namespace

const std::vector<std::string>& ablation_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all = paper_instances();
    all.insert(all.end(), reducible().begin(), reducible().end());
    return all;
  }();
  return ids;
}

std::vector<Variant> ablation_variants() {
  std::vector<Variant> variants;
  for (const auto& studies : {path_studies(), saving_studies()})
    for (const Study& study : studies)
      variants.insert(variants.end(), study.variants.begin(), study.variants.end());
  return variants;
}

std::vector<Table> build_ablation(const RunFile& run, const Publication&) {
  std::vector<Table> tables{build_paths(run), build_savings(run)};
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace gcs
