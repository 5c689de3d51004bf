/// How much faster one strategy is than another on the same machine, with an interval, and what of it is due to what.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// "23.4 (21.9–25.1)": both medians at the ends of their intervals that are worst and best for the faster
/// one.
TableCell speed_up_entry(Table& table, const CellRecord* slow, const CellRecord* fast) {
  const auto slow_time = total_time(slow);
  const auto fast_time = total_time(fast);
  if (!fast_time) return time_entry(table, fast);
  if (!slow_time) return time_entry(table, slow);
  const std::string ratio = number_text(slow_time->median / fast_time->median);
  if (std::min(slow_time->confidence, fast_time->confidence) < wanted_confidence)
    return {ratio, {table.footnote("Of fewer than 6 runs: too few for an interval.")}};
  return {fmt::format("{} ({}–{})", ratio, number_text(slow_time->low / fast_time->high),
                      number_text(slow_time->high / fast_time->low)),
          {}};
}

/// The paper's own ratio.
TableCell published_entry(const Publication& paper, const std::string& instance) {
  const PrintedFigure* without = paper.find("table 2", "time_s", instance, "tracking S");
  const PrintedFigure* with = paper.find("table 2", "time_s", instance, "Algorithm 1");
  if (without == nullptr || with == nullptr) return empty_entry();
  return {number_text(without->value / with->value), {}};
}

/// A number of a cell whose ratio without to with a plan explains that of the times.
struct Cost {
  const char* label;
  std::optional<double> (*of)(const CellRecord& cell, const InstanceSummary& instance);
};

std::optional<double> per_step(const CellRecord& cell, std::int64_t count) {
  if (cell.work.iterations == 0) return std::nullopt;
  return static_cast<double>(count) / static_cast<double>(cell.work.iterations);
}

/// t included.
double unknowns(const CellRecord& cell, const InstanceSummary& instance) {
  return 1 + cell.work.mean_driving_parameters.value_or(instance.equations);
}

constexpr std::array costs{
    Cost{"time",
         [](const CellRecord& cell, const InstanceSummary&) -> std::optional<double> {
           const auto time = total_time(&cell);
           return time ? std::optional(time->median * 1e3) : std::nullopt;
         }},
    Cost{"steps",
         [](const CellRecord& cell, const InstanceSummary&) {
           return std::optional(static_cast<double>(cell.work.iterations));
         }},
    Cost{"corrections per step",
         [](const CellRecord& cell, const InstanceSummary&) {
           return per_step(cell, cell.work.newton_iterations);
         }},
    Cost{"unknowns, t included",
         [](const CellRecord& cell, const InstanceSummary& instance) {
           return std::optional(unknowns(cell, instance));
         }},
    Cost{
        "evaluations per step",
        [](const CellRecord& cell, const InstanceSummary&) { return per_step(cell, cell.work.evaluations); }},
    Cost{"partial evaluations per step",
         [](const CellRecord& cell, const InstanceSummary&) {
           return per_step(cell, cell.work.partial_evaluations);
         }},
    Cost{"eliminations per step",
         [](const CellRecord& cell, const InstanceSummary&) {
           return per_step(cell, cell.work.factorisations);
         }},
    Cost{"their multiplications per step",
         [](const CellRecord& cell, const InstanceSummary& instance) {
           const auto count = per_step(cell, cell.work.factorisations);
           const double n = unknowns(cell, instance);
           return count ? std::optional(*count * n * n * n / 3) : std::nullopt;
         }},
};

void add_cost_rows(Table& table, const RunFile& run, const Variant& without, const Variant& with) {
  table.rows.push_back(
      {fmt::format("{} against {}", label_of(with.on("")), label_of(without.on(""))), {}, {}});
  for (const Cost& cost : costs) {
    TableRow row{cost.label, {}, {}};
    for (const InstanceSummary& instance : run.instances) {
      std::array<std::optional<double>, 2> numbers;
      for (int side = 0; side < 2; ++side) {
        const CellRecord* cell = run.find((side == 0 ? without : with).on(instance.id));
        if (cell != nullptr && cell->status == RunStatus::complete) numbers[side] = cost.of(*cell, instance);
        row.cells.push_back(answer_entry(table, cell, numbers[side]));
      }
      const bool has_ratio = numbers[0] && numbers[1] && *numbers[1] > 0;
      row.cells.push_back(has_ratio ? TableCell{number_text(*numbers[0] / *numbers[1]), {}} : empty_entry());
    }
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

Table build_costs(const RunFile& run) {
  Table table;
  table.name = "costs";
  table.caption =
      "Where the speed-up of a plan comes from: without, with, and the ratio, at equal largest steps";
  for (const InstanceSummary& instance : run.instances)
    table.groups.push_back({instance.id, {"without", "with", "ratio"}});
  add_cost_rows(table, run, {"full-space", {{"mode", "paper"}, {"step_max", "0.05"}}},
                {"rcp", {{"mode", "paper"}}});
  add_cost_rows(table, run, {"full-space", {}}, {"rcp", {}});
  table.remarks = {
      defaults_remark,
      "time: median, preparing and solving once. The ratio of the times is that of the steps times "
      "that "
      "of the cost of a step. mode=paper differentiates by finite differences, a Jacobian being one "
      "evaluation "
      "for each unknown: of all m distances without a plan, of a part of the plan with it; an elimination "
      "takes "
      "a third of the cube of the unknowns in multiplications, with a plan of their mean. mode=fast "
      "differentiates exactly, and a step costs one elimination and its series."};
  return table;
}

Table build_ratios(const RunFile& run, const Publication& paper) {
  const Variant full_paper{"full-space", {{"mode", "paper"}}};
  const Variant full_paper_small{"full-space", {{"mode", "paper"}, {"step_max", "0.05"}}};
  const Variant full_fast{"full-space", {}};
  const Variant rcp_paper{"rcp", {{"mode", "paper"}}};
  const Variant rcp_fast{"rcp", {}};
  const std::array<std::pair<Variant, Variant>, 6> pairs{{{full_paper, rcp_fast},
                                                          {full_paper_small, rcp_fast},
                                                          {full_fast, rcp_fast},
                                                          {full_paper, rcp_paper},
                                                          {full_paper_small, rcp_paper},
                                                          {full_paper, full_fast}}};

  Table table;
  table.name = "ratios";
  table.caption = "Speed-ups: how many times faster the first strategy is than the second";
  for (const InstanceSummary& instance : run.instances) table.groups.push_back({instance.id, {""}});
  TableRow published{"published: Algorithm 1 against tracking S", {}, {}};
  for (const InstanceSummary& instance : run.instances) {
    published.cells.push_back(published_entry(paper, instance.id));
  }
  table.rows.push_back(std::move(published));
  for (const auto& [slow, fast] : pairs) {
    TableRow row{fmt::format("{} against {}", label_of(fast.on("")), label_of(slow.on(""))), {}, {}};
    for (const InstanceSummary& instance : run.instances) {
      row.cells.push_back(
          speed_up_entry(table, run.find(slow.on(instance.id)), run.find(fast.on(instance.id))));
    }
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      defaults_remark,
      "Ratio of the medians; in brackets, the ratios of the ends of their 95% intervals. No ratio where one "
      "of the two has no time."};
  return table;
}

}  // namespace gcs
