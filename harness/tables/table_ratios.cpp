/// How much faster one strategy is than another on the same machine, with an interval.

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

}  // namespace

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
