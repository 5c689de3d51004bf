/// How often the plan has to be changed where S turns exponentially often (Imbach et al., section 7.3.3).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/drawings/svg_plot.hpp"
#include "harness/instances/families.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

constexpr std::string_view chain_family = "rocker-chain";

const Variant proof_of_turns{"full-space", {{"mode", "certified"}}};
const Variant by_series{"rcp", {}};
const Variant at_published_steps{"rcp", {{"mode", "paper"}}};
const Variant at_half_steps{"rcp", {{"mode", "paper"}, {"step_max", "0.025"}}};

/// n of "rocker-chain@n".
int rockers_of(const std::string& id) { return std::stoi(id.substr(id.find('@') + 1)); }

/// As harness/instances/rocker_chain.cpp derives.
double turns_of(const std::string& id) { return std::exp2(rockers_of(id) + 1) - 2; }

std::optional<double> exchanges_of(const CellRecord* cell) { return particular(cell, "exchanges"); }

std::optional<double> changes_of(const CellRecord* cell) {
  return work_count(cell, &WorkCounters::plan_changes);
}

TableCell growth_entry(std::optional<double> now, std::optional<double> before) {
  if (!now || !before) return empty_entry();
  return {number_text(*now / *before), {}};
}

TableRow chain_row(Table& table, const RunFile& run, const InstanceSummary& instance,
                   const std::string& smaller) {
  const auto cell_of = [&](const Variant& variant) { return run.find(variant.on(instance.id)); };
  const CellRecord *half = cell_of(at_half_steps), *series = cell_of(by_series),
                   *proof = cell_of(proof_of_turns), *published = cell_of(at_published_steps);
  const auto counted = [&](const CellRecord* cell, std::int64_t WorkCounters::*counter) {
    return answer_entry(table, cell, work_count(cell, counter));
  };
  TableRow row{fmt::format("{}", rockers_of(instance.id)), {}, {}};
  row.cells = {{fmt::format("{}", instance.equations), {}},
               {number_text(turns_of(instance.id)), {}},
               answer_entry(table, proof, on_path(proof)),
               counted(proof, &WorkCounters::iterations),
               counted(half, &WorkCounters::iterations),
               answer_entry(table, half, exchanges_of(half)),
               answer_entry(table, half, changes_of(half)),
               growth_entry(changes_of(half), changes_of(run.find(at_half_steps.on(smaller)))),
               answer_entry(table, half, half == nullptr ? std::nullopt : half->work.mean_driving_parameters),
               answer_entry(table, published, exchanges_of(published)),
               counted(series, &WorkCounters::iterations),
               answer_entry(table, series, changes_of(series)),
               growth_entry(changes_of(series), changes_of(run.find(by_series.on(smaller))))};
  return row;
}

/// A symbol for each instance that was measured.
template <class ValueOf>
PlotSeries series_over(const RunFile& run, std::string label, int style, const ValueOf& value_of) {
  PlotSeries series{std::move(label), PlotMark::symbol, {}, style};
  for (const InstanceSummary& instance : run.instances)
    if (const std::optional<double> value = value_of(instance); value && *value > 0)
      series.points.push_back({static_cast<double>(rockers_of(instance.id)), std::log10(*value)});
  return series;
}

}  // namespace

const std::vector<std::string>& plan_changes_instances() {
  static const std::vector<std::string> ids = find_family(chain_family)->members();
  return ids;
}

std::vector<Variant> plan_changes_variants() {
  return {proof_of_turns, at_half_steps, at_published_steps, by_series};
}

std::vector<Table> build_plan_changes(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "plan-changes";
  table.caption = "Changes of the plan on a chain of n rockers, on which S turns 2^(n+1) − 2 times";
  table.stub = "n";
  table.groups = {
      {"", {"m", "turns of S"}},
      {"full-space, mode=certified", {"on S, proven", "tubes"}},
      {"rcp, mode=paper, δmax = 0.025", {"iterations", "exchanges", "changes", "growth", "mean DP"}},
      {"δmax = 0.05", {"exchanges"}},
      {"rcp", {"iterations", "changes", "growth"}}};
  std::string smaller;
  for (const InstanceSummary& instance : run.instances) {
    table.rows.push_back(chain_row(table, run, instance, smaller));
    smaller = instance.id;
  }
  table.remarks = {
      "Two points and four constraints more double the solutions on S, the turns of S in t and the changes "
      "of the plan: they grow exponentially in m, as the paper says of the worst case. So does S itself, "
      "with a plan or without.",
      "turns of S: by theory, at each of which a plan without driving parameters is in a boundary "
      "configuration and exchanges one instruction; what was exchanged is restored when the plan is next "
      "changed. growth: over the row before. m: constraints. on S: solutions up to reflection; the only "
      "rocker of n = 1 passes its own mirror image.",
      "δmax = 0.05 is the published one, 0.025 half of it. Where a path has jumped to another arc, it may "
      "go round S several times, in both directions, before it ends.",
      "The claim, in section 7.3.3: " + paper.citation + "."};
  return {table};
}

std::vector<Drawing> draw_plan_changes(const RunFile& run) {
  Plot plot;
  plot.description = "Turns of S, changes of the plan and steps over the number of rockers";
  plot.series = {
      series_over(run, "turns of S", 0,
                  [](const InstanceSummary& i) { return std::optional(turns_of(i.id)); }),
      series_over(run, "changes, mode=paper", 1,
                  [&](const InstanceSummary& i) { return changes_of(run.find(at_half_steps.on(i.id))); }),
      series_over(run, "changes, mode=fast", 2,
                  [&](const InstanceSummary& i) { return changes_of(run.find(by_series.on(i.id))); }),
      series_over(run, "steps, mode=fast", 3, [&](const InstanceSummary& i) {
        return work_count(run.find(by_series.on(i.id)), &WorkCounters::iterations);
      })};
  double most_rockers = 2, most = 1;
  for (const PlotSeries& one : plot.series)
    for (const PlotPoint& point : one.points) {
      most_rockers = std::max(most_rockers, point[0]);
      most = std::max(most, point[1]);
    }
  plot.x = axis_over("rockers", 1, most_rockers);
  plot.y = decades_over("number", 0, most);
  return {{"plan-changes", to_svg(plot), plot.description}};
}

}  // namespace gcs
