#include "harness/tables/table_entries.hpp"

#include <fmt/format.h>

#include <cmath>

#include "harness/base/time_left.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/solving/counts_view.hpp"

namespace gcs {
namespace {

/// Of too few runs there is no interval, but all of them.
std::string spread_text(const MedianInterval& interval, std::size_t runs) {
  if (runs == 1) return "(1 run)";
  if (interval.confidence < wanted_confidence)
    return fmt::format("({}–{}, {} runs)", duration_text(interval.low), duration_text(interval.high), runs);
  const double percent = 100 * interval.relative_half_width();
  return percent < 1 ? "±<1%" : fmt::format("±{:.0f}%", percent);
}

std::string obstacle_word(const CellRecord& cell) {
  if (cell.status == RunStatus::complete) return "no time";
  if (cell.status != RunStatus::timed_out) return std::string(word(cell.status));
  return cell.estimate_s ? fmt::format("not run ({})", rough_time(*cell.estimate_s)) : "not run";
}

/// Why the cell has no right answer: a word with the reason in a footnote.
TableCell obstacle(Table& table, const CellRecord* cell) {
  if (cell == nullptr) return {"not measured", {}};
  const std::string reason = fmt::format("{}, {}: {}", cell->spec.instance, label_of(cell->spec),
                                         cell->status == RunStatus::complete ? cell->flaw() : cell->reason);
  return {obstacle_word(*cell), {table.footnote(reason)}};
}

}  // namespace

TableCell empty_entry() { return {"–", {}}; }

std::string number_text(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) && size < 1e15) return fmt::format("{:.0f}", value);
  return size >= 100 && size < 1e15 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string duration_text(double seconds) {
  if (seconds >= 1) return number_text(seconds) + " s";
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} µs", seconds * 1e6);
}

std::optional<double> number(const std::optional<Natural>& count) {
  return count ? std::optional(count->approximate()) : std::nullopt;
}

std::optional<double> particular(const CellRecord* cell, std::string_view name) {
  const auto count = cell == nullptr ? std::nullopt : cell->particular(name);
  return count ? std::optional(static_cast<double>(*count)) : std::nullopt;
}

std::optional<double> work_count(const CellRecord* cell, std::int64_t WorkCounters::*counter) {
  return cell == nullptr ? std::nullopt : std::optional(static_cast<double>(cell->work.*counter));
}

std::optional<double> proven_real(const CellRecord* cell) {
  if (cell == nullptr || !cell->proofs) return std::nullopt;
  return static_cast<double>(cell->proofs->real);
}

std::optional<double> tracked_paths(const CellRecord* cell) {
  const auto count = cell == nullptr ? std::nullopt : cell->counts.paths;
  return count && *count > 0 ? std::optional(static_cast<double>(*count)) : std::nullopt;
}

std::optional<double> finite_path_ends(const CellRecord* cell) {
  const auto all = tracked_paths(cell);
  if (!all) return std::nullopt;
  return *all - static_cast<double>(cell->counts.at_infinity.value_or(0)) -
         static_cast<double>(cell->counts.failed_paths.value_or(0));
}

std::string limit_origin(const RecordedLimit& limit) {
  if (limit.is_exact) return "Exact at generic lengths: recursion over bigraphs, Capco et al. 2018.";
  const BoundNames& bound = limit.bound;
  const std::string_view source = bound.parts > 1 || !bound.theorem.empty() ? "."
                                  : !bound.ring.empty()      ? "; given shapes close in at most 16 ways."
                                  : !bound.reference.empty() ? ", Bartzos, Emiris, Schicho 2020."
                                                             : ", Macdonald, Pach, Theobald 2001.";
  return bound_origin(bound) + std::string(source);
}

TableCell printed_entry(Table& table, const PrintedFigure* figure) {
  if (figure == nullptr) return empty_entry();
  TableCell cell{figure->printed, {}};
  if (figure->correction) {
    cell.notes.push_back(table.footnote(
        fmt::format("{}. {} ({})", figure->correction->is_proof ? "Known to be wrong" : "Not reproduced",
                    figure->correction->reason, figure->correction->source)));
  }
  for (const std::string& text : {figure->remark, figure->chosen})
    if (!text.empty()) cell.notes.push_back(table.footnote(text));
  return cell;
}

std::optional<MedianInterval> total_time(const CellRecord* cell) {
  if (cell == nullptr || cell->repetitions.empty()) return std::nullopt;
  std::vector<double> seconds;
  for (const Timing& repetition : cell->repetitions) seconds.push_back(repetition.total_s());
  return median_interval(std::move(seconds), wanted_confidence);
}

TableCell time_entry(Table& table, const CellRecord* cell) {
  if (cell == nullptr || !cell->is_right()) return obstacle(table, cell);
  const auto time = total_time(cell);
  if (!time) return {"not timed", {}};
  return {duration_text(time->median) + " " + spread_text(*time, cell->repetitions.size()), {}};
}

TableCell answer_entry(Table& table, const CellRecord* cell, std::optional<double> value) {
  if (cell == nullptr || cell->status != RunStatus::complete) return obstacle(table, cell);
  if (!value) return empty_entry();
  TableCell entry{number_text(*value), {}};
  if (!cell->is_right()) entry.notes = obstacle(table, cell).notes;
  return entry;
}

TableCell ratio_entry(std::optional<double> ours, const PrintedFigure* figure) {
  if (!ours || figure == nullptr || figure->value == 0) return empty_entry();
  return {number_text(*ours / figure->value), {}};
}

}  // namespace gcs
