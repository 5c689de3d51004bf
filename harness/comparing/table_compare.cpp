#include "harness/comparing/table_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "harness/tables/table_entries.hpp"

namespace gcs {
namespace {

std::string name_of(const CellSpec& spec) { return fmt::format("{}, {}", spec.instance, label_of(spec)); }

std::string_view word(ChangeVerdict verdict) {
  constexpr std::array<std::string_view, 3> words{"better", "worse", "different"};
  return words[static_cast<std::size_t>(verdict)];
}

Table empty_table(std::string_view name, std::string_view caption, std::string_view stub) {
  Table table;
  table.name = fmt::format("compare-{}", name);
  table.caption = caption;
  table.stub = stub;
  return table;
}

Table setup_table(const Comparison& comparison) {
  Table table = empty_table("setup", "What the runs were made with, as far as it differs", "");
  table.groups = {{"", {"A", "B"}}};
  for (const Changed& changed : comparison.setup)
    table.rows.push_back({changed.what, {{changed.before, {}}, {changed.after, {}}}, {}});
  table.remarks = {"A: " + comparison.before_made + ".", "B: " + comparison.after_made + "."};
  if (!comparison.is_same_machine)
    table.remarks.emplace_back(
        "The runs were made on different processors or with different numbers of threads: times do not speak "
        "of "
        "the program, and are no regression.");
  return table;
}

Table answers_table(const Comparison& comparison) {
  Table table = empty_table("answers", "Answers that differ", "instance, strategy");
  table.groups = {{"", {"what", "A", "B", "B is"}}};
  for (const AnswerChange& change : comparison.answers)
    table.rows.push_back({name_of(change.cell),
                          {{change.changed.what, {}},
                           {change.changed.before, {}},
                           {change.changed.after, {}},
                           {std::string(word(change.verdict)), {}}},
                          {}});
  return table;
}

Table work_table(const Comparison& comparison) {
  Table table = empty_table("work", "Work that differs", "instance, strategy");
  table.groups = {{"", {"counter", "A", "B"}}};
  for (const WorkChange& change : comparison.work)
    table.rows.push_back(
        {name_of(change.cell),
         {{change.changed.what, {}}, {change.changed.before, {}}, {change.changed.after, {}}},
         {}});
  table.remarks.emplace_back("The counters do not depend on the machine: one program gives the same twice.");
  return table;
}

std::string interval_text(const MedianRatio& ratio) {
  return fmt::format("{:.3g} to {:.3g}", ratio.low, ratio.high);
}

std::string median_text(const MedianInterval& time) { return duration_text(time.median); }

std::string percent_text(double share) { return fmt::format("{:.6g} %", 100 * share); }

/// Of each run, so that the widest interval of order statistics reaches the confidence (see median_ratio).
int runs_needed(const Comparison& comparison) {
  const double share = (1 - comparison.settings.confidence) / static_cast<double>(comparison.times.size());
  const double of_each = -std::expm1(std::log1p(-share) / 2);
  return static_cast<int>(std::ceil(1 - std::log2(of_each)));
}

std::vector<std::string> times_remarks(const Comparison& comparison) {
  const CompareSettings& settings = comparison.settings;
  const auto cells = static_cast<double>(comparison.times.size());
  std::vector<std::string> remarks{
      "Times: preparing and solving once, medians of the repetitions. Ratio: B / A. Its interval: from B's "
      "lower limit / A's upper one to B's upper / A's lower. These limits of the medians are order "
      "statistics "
      "and hold whatever the distribution of the times.",
      fmt::format(
          "Together: with {}, none of the {} ratios lies outside its interval. For that each interval holds "
          "with {} (Bonferroni), which takes {} repetitions in both runs; of intervals with 95 % up to one "
          "in 20 would miss its ratio by chance.",
          percent_text(settings.confidence), cells, percent_text(1 - (1 - settings.confidence) / cells),
          runs_needed(comparison)),
      "Processor: the ratio of medians with the time that the processor spent on solving. Where it does not "
      "agree, "
      "the program waited for other processes.",
      fmt::format(
          "Slower, faster: the interval of all together and the processor's ratio lie beyond a margin of "
          "{}; alike: the interval lies within. By less two runs of one program differ too, since memory, "
          "clock rate and other processes are not the same twice.",
          percent_text(settings.margin)),
  };
  if (comparison.was_busy)
    remarks.emplace_back(
        "Other processes wanted to run when these runs started (see their load averages): their times are "
        "less "
        "certain than the intervals say.");
  return remarks;
}

Table times_table(const Comparison& comparison) {
  Table table = empty_table("times", "Times", "instance, strategy");
  table.groups = {{"median", {"A", "B"}}, {"B / A", {"ratio", "95 %", "together", "processor", "B is"}}};
  for (const TimeChange& change : comparison.times)
    table.rows.push_back({name_of(change.cell),
                          {{median_text(change.before), {}},
                           {median_text(change.after), {}},
                           {fmt::format("{:.3g}", change.together.ratio), {}},
                           {change.alone.confidence < 0.95 ? "–" : interval_text(change.alone), {}},
                           {change.pace == Pace::too_few_runs ? "–" : interval_text(change.together), {}},
                           {fmt::format("{:.3g}", change.processor), {}},
                           {std::string(word(change.pace)), {}}},
                          {}});
  if (!comparison.times.empty()) table.remarks = times_remarks(comparison);
  return table;
}

Table missing_table(const Comparison& comparison) {
  Table table = empty_table("missing", "Cells that only one run has measured", "instance, strategy");
  table.groups = {{"", {"measured in"}}};
  for (const CellSpec& spec : comparison.only_before) table.rows.push_back({name_of(spec), {{"A", {}}}, {}});
  for (const CellSpec& spec : comparison.only_after) table.rows.push_back({name_of(spec), {{"B", {}}}, {}});
  return table;
}

std::string answers_line(const Comparison& comparison) {
  const auto count = [&](ChangeVerdict verdict) {
    return std::count_if(comparison.answers.begin(), comparison.answers.end(),
                         [&](const AnswerChange& change) { return change.verdict == verdict; });
  };
  return fmt::format("Answers of {} cells in both runs: {} worse, {} better, {} otherwise different.",
                     comparison.compared, count(ChangeVerdict::worse), count(ChangeVerdict::better),
                     count(ChangeVerdict::different));
}

std::string times_line(const Comparison& comparison) {
  const auto count = [&](Pace pace) {
    return std::count_if(comparison.times.begin(), comparison.times.end(),
                         [&](const TimeChange& change) { return change.pace == pace; });
  };
  std::string text = fmt::format("Times of {} cells:", comparison.times.size());
  for (const Pace pace : {Pace::slower, Pace::faster, Pace::alike, Pace::undecided, Pace::too_few_runs})
    text += fmt::format("{} {} {}", pace == Pace::slower ? "" : ",", count(pace), word(pace));
  return text + ".";
}

}  // namespace

ComparisonTables build_comparison(const Comparison& comparison, const std::string& before,
                                  const std::string& after) {
  ComparisonTables shown;
  for (const auto build : {setup_table, answers_table, times_table, work_table, missing_table}) {
    Table table = build(comparison);
    if (table.rows.empty()) continue;
    table.remarks.insert(table.remarks.begin(), fmt::format("A is {}, B is {}.", before, after));
    shown.tables.push_back(std::move(table));
  }
  shown.lines = {answers_line(comparison), times_line(comparison),
                 comparison.has_regressed() ? "B has regressed." : "B has not regressed."};
  return shown;
}

}  // namespace gcs
