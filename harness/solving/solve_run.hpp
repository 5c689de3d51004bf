#pragma once
/// One strategy on one scene, timed and assessed: the only way in which the program solves.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/answers/assess.hpp"
#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

struct RunLimits {
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<double> time_limit_s = std::nullopt;        ///< over prepare, solve and, if so, proofs
  std::optional<std::size_t> max_solutions = std::nullopt;  ///< how many classes are kept
  bool only_real = false;                                   ///< leave complex solutions out of the list
  bool checks_counts = true;                                ///< against the theoretical ones
  bool certify = false;                                     ///< prove what is listed (see certify)
  bool limits_proofs = true;  ///< the time limit is for proofs too; an interrupt always stops them
  int digits = 0;             ///< to which every solution is refined; 0: as the strategy gives it, in doubles
};

enum class RunStatus { complete, partial, infinite, unsupported, gave_up, interrupted, timed_out };

/// The word of gcsbench-result/1: "complete", …, "gave up", "timed out".
std::string_view word(RunStatus status);
/// The word of gcsbench-result/1: "some real", "on path", …
std::string_view word(Claim claim);

inline constexpr std::array all_statuses{RunStatus::complete,    RunStatus::partial, RunStatus::infinite,
                                         RunStatus::unsupported, RunStatus::gave_up, RunStatus::interrupted,
                                         RunStatus::timed_out};
inline constexpr std::array all_claims{Claim::some_real, Claim::on_path, Claim::on_path_of_core,
                                       Claim::all_real, Claim::all_complex};

/// Of prepare and solve alone; assessing is not timed.
struct Timing {
  double wall_s = 0;                ///< of solve
  double cpu_s = 0;                 ///< of solve, all threads together
  double prepare_s = 0;             ///< wall time of prepare
  std::int64_t recalled_steps = 0;  ///< taken from the journal of an earlier run, and so not in these times
  std::optional<double> certify_s = std::nullopt;  ///< wall time of proving the assessment, if asked for
  double refine_s = 0;                             ///< wall time of refining to more digits, if asked for
};

struct SolveRun {
  std::string strategy;
  OptionMap options;  ///< every option of the strategy, defaults included
  std::uint64_t seed = 1;
  int threads = 1;
  RunStatus status = RunStatus::gave_up;
  std::string reason;          ///< empty when complete
  std::optional<Claim> claim;  ///< empty when nothing was run
  Assessment assessment;
  /// Of each solution of the assessment, to the digits asked for; nothing where it is not proven to so many.
  /// Empty unless asked for.
  std::vector<std::optional<DecimalFigure>> refined;
  WorkCounters work;
  std::vector<Particular> particulars;  ///< counts that only this strategy knows
  Timing timing;
};

/// What a run may use of the outside; each may be null.
struct RunServices {
  Monitor* monitor = nullptr;
  Journal* journal = nullptr;
};

/// Why `strategy`, made from `entry`, cannot do `scene`: its own reason, or no sketch; nullopt when it can.
std::optional<std::string> why_not(const StrategyEntry& entry, const Strategy& strategy, const Scene& scene);

/// Runs the strategy until it ends, the time limit passes or the user interrupts (see catch_interrupts).
/// An exception from the strategy becomes RunStatus::gave_up. Throws OptionError for options that are not
/// allowed, and InputError and OutputError for files: of the services, and those that the options name.
SolveRun run_strategy(const StrategyEntry& entry, const OptionMap& given, const Scene& scene,
                      const RunLimits& limits, const RunServices& services = {});

}  // namespace gcs
