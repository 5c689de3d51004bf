#pragma once
/// Two runs held against each other: what they were made with, answers, work and times.

#include <string>
#include <string_view>
#include <vector>

#include "harness/comparing/compare_answers.hpp"
#include "harness/results/median_interval.hpp"
#include "harness/runs/run_file.hpp"

namespace gcs {

struct CompareSettings {
  /// With this probability no time is called slower or faster that is neither, all cells together.
  double confidence = 0.95;
  /// Medians whose ratio is between 1/(1 + margin) and 1 + margin are alike: two runs of one program differ
  /// by as much, since memory, clock rate and other processes are not the same twice.
  double margin = 0.1;
};

struct WorkChange {
  CellSpec cell;
  Changed changed;
};

/// How the times of a cell compare.
enum class Pace {
  alike,         ///< within the margin
  slower,        ///< by more than the margin
  faster,        ///< likewise
  undecided,     ///< the interval reaches into two of these, or the processor's time does not agree
  too_few_runs,  ///< to reach the confidence
};

/// "alike", "slower", "faster", "undecided", "too few runs"
std::string_view word(Pace pace);

struct TimeChange {
  CellSpec cell;
  MedianInterval before;  ///< seconds, as total_time
  MedianInterval after;
  MedianRatio alone;     ///< 95 % for this cell
  MedianRatio together;  ///< CompareSettings::confidence for all cells: Bonferroni's share of one
  double processor = 0;  ///< ratio of the medians with the processor's time for that of the clock in solve
  Pace pace = Pace::undecided;
};

struct Comparison {
  CompareSettings settings;
  std::string before_made, after_made;  ///< when, and by which command line
  std::vector<Changed> setup;           ///< environment, seed, limits, instances
  bool is_same_machine = false;         ///< otherwise times do not speak of the program
  bool was_busy = false;                ///< other processes wanted to run when a session of either started
  std::vector<AnswerChange> answers;
  std::vector<WorkChange> work;
  std::vector<TimeChange> times;  ///< of all cells with times in both
  std::vector<CellSpec> only_before;
  std::vector<CellSpec> only_after;
  int compared = 0;  ///< cells in both

  /// An answer is worse, or on the same machine a time is slower.
  bool has_regressed() const;
};

/// Cells are those of one instance, strategy and options in both runs, measured in both. Instances whose
/// content has changed are not compared, and said so in the setup.
Comparison compare_runs(const RunFile& before, const RunFile& after, const CompareSettings& settings);

}  // namespace gcs
