#pragma once
/// Measures cells fairly: every answer is assessed before anything is timed, a wrong answer gets no time, and
/// repetitions of all cells are interleaved, so that a slow minute of the machine touches all of them alike,
/// in another random order each time, so that none always finds the caches as the same other one leaves them.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/runs/agreement.hpp"
#include "harness/runs/run_file.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// One cell to measure. `entry` and `scene` outlive the measurement.
struct CellTask {
  CellSpec spec;
  const StrategyEntry* entry = nullptr;
  const Scene* scene = nullptr;
  bool keeps_solutions = false;  ///< in the record, for tables that show them
  bool is_timed = true;          ///< false: solved once, for its answer
  /// Gives what holds the answer against the reference; empty, or null where there is none: certificates do.
  /// Called before a cell is solved for the first time, so that cells that are known cost nothing.
  std::function<const AccuracyJudge*(Monitor& progress)> judge = {};
};

/// How long a measurement may take.
struct TimingLimits {
  double budget_s = 90;                        ///< for all repetitions of all cells together
  std::optional<double> cell_limit_s = 60;     ///< for one solve, not its proofs
  std::optional<double> total_limit_s = 1800;  ///< for everything; cells that are left are not run
  bool skips_variants = false;  ///< of a strategy whose default settings were too slow for the instance
};

struct TimingSettings {
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<int> repetitions;  ///< empty: as many as the budget allows, between 3 and 101
  TimingLimits limits;
  ExpectedCounts expected;
};

/// Receives the cells as they stand, to be stored: after every warm-up and, since storing may cost more than
/// a repetition, when a second of repetitions has passed.
using CellCheckpoint = std::function<void(const std::vector<CellRecord>& cells)>;

/// Measures all tasks, in their order. `known` holds cells of an earlier session of the same program: what is
/// decided is not solved again, repetitions that are there count, and only those that are missing are added.
/// A solve that was stopped by its time limit is repeated when it may take longer now. What is known of cells
/// whose turn has not come is stored and returned with the rest. After an interrupt (see stop_conditions.hpp)
/// what is there is returned.
std::vector<CellRecord> time_cells(std::span<const CellTask> tasks, const TimingSettings& settings,
                                   const std::vector<CellRecord>& known, Monitor& progress,
                                   const CellCheckpoint& checkpoint);

}  // namespace gcs
