#pragma once
/// One strategy on one scene, timed: the only way in which the program solves.

#include <cstdint>
#include <optional>

#include "solvers/solving/solve.hpp"

namespace gcs {

struct RunLimits : SolveSettings {
  std::optional<double> time_limit_s = std::nullopt;  ///< over prepare, solve and, if so, proofs
  bool limits_proofs = true;  ///< the time limit is for proofs too; an interrupt always stops them
};

/// In seconds, on a steady clock. Of prepare and solve alone; assessing is not timed.
struct Timing {
  double wall_s = 0;                ///< of solve
  double cpu_s = 0;                 ///< of solve, all threads together
  double prepare_s = 0;             ///< wall time of prepare
  std::int64_t recalled_steps = 0;  ///< taken from the journal of an earlier run, and so not in these times
  std::optional<double> certify_s = std::nullopt;  ///< wall time of proving the assessment, if asked for
  double refine_s = 0;                             ///< wall time of refining to more digits, if asked for

  /// What somebody who solves once waits for.
  double total_s() const { return prepare_s + wall_s + refine_s; }
};

/// A solve that was stopped is `interrupted` or `timed_out`.
struct SolveRun : Answer {
  Timing timing;
};

/// What a run may use of the outside; each may be null.
struct RunServices {
  Monitor* monitor = nullptr;
  Journal* journal = nullptr;
  Crew* crew = nullptr;
};

/// Runs the strategy until it ends, the time limit passes or the user interrupts (see catch_interrupts). Throws what
/// solve throws, and InputError and OutputError for files: of the services, and those that the options name.
SolveRun run_strategy(const StrategyEntry& entry, const OptionMap& given, const Scene& scene,
                      const RunLimits& limits, const RunServices& services = {});

}  // namespace gcs
