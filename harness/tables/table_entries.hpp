#pragma once
/// What the entries of tables say: one wording and one rounding for all tables. An entry is never blank: what
/// has no number says why, in a word and a footnote.

#include <optional>
#include <string>
#include <string_view>

#include "harness/results/median_interval.hpp"
#include "harness/runs/published.hpp"
#include "harness/runs/run_file.hpp"
#include "harness/tables/table.hpp"

namespace gcs {

/// Where a table has nothing to say: the paper prints no figure, or a ratio has no two sides.
TableCell empty_entry();

/// Three significant digits, integers above that in full.
std::string number_text(double value);

/// "2.13 ms": three significant digits in s, ms or µs.
std::string duration_text(double seconds);

/// A count of the answer, where it has one.
std::optional<double> number(const std::optional<Natural>& count);

/// The particular of that name, where there is a cell that has it.
std::optional<double> particular(const CellRecord* cell, std::string_view name);

/// A counter of its work, where there is a cell.
std::optional<double> work_count(const CellRecord* cell, std::int64_t WorkCounters::*counter);

/// Solutions that are proven to be real, each in a class of its own.
std::optional<double> proven_real(const CellRecord* cell);

/// Of a strategy that follows no paths nothing is counted.
std::optional<double> tracked_paths(const CellRecord* cell);

/// Of these, the ends that are finite, regular and singular ones together.
std::optional<double> finite_path_ends(const CellRecord* cell);

/// Where the number, or the bound, of complex solutions comes from: a sentence with its source.
std::string limit_origin(const RecordedLimit& limit);

/// A printed figure as the paper has it. A correction and a remark become footnotes.
TableCell printed_entry(Table& table, const PrintedFigure* figure);

/// What one repetition waits for, prepare and solve together: median and interval, in seconds. Empty when
/// there are no times.
std::optional<MedianInterval> total_time(const CellRecord* cell);

/// "2.13 ms ±3%", where ± is half of the median's interval, or with the range of too few runs
/// (spread_remark). Without times: why.
TableCell time_entry(Table& table, const CellRecord* cell);

/// Of the intervals in tables.
inline constexpr double wanted_confidence = 0.95;

/// What ± means in every table.
inline constexpr const char* spread_remark =
    "± half of the median's 95% interval, which takes 6 runs; of fewer, the shortest and the longest";

/// A number that the cell's answer gives, shown even when the answer is wrong (with a footnote);
/// without an answer: why.
TableCell answer_entry(Table& table, const CellRecord* cell, std::optional<double> value);

/// ours / printed; the empty entry unless there are both.
TableCell ratio_entry(std::optional<double> ours, const PrintedFigure* figure);

/// What such a label means when it names no options.
inline constexpr const char* defaults_remark =
    "A strategy without options runs with its defaults (mode=fast).";

}  // namespace gcs
