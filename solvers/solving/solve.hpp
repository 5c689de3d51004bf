#pragma once
/// One strategy on one scene: it is asked, its report is assessed and, when that is wanted, proven and refined.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "solvers/interface/options.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// What is asked of any strategy.
struct SolveSettings {
  std::uint64_t seed =
      1;  ///< of everything random: the same seed gives the same answer, for any number of threads
  int threads = 1;
  std::optional<std::size_t> max_solutions = std::nullopt;  ///< how many classes are kept
  bool only_real = false;                                   ///< leave complex solutions out of the list
  bool checks_counts = true;                                ///< against the theoretical ones
  bool certify = false;                                     ///< prove what is listed (see certify)
  int digits = 0;  ///< to which every solution is refined; 0: as the strategy gives it, in doubles
};

/// Where a solve is. `listing`: what was asked for is taken from what was found and, maybe, proven.
enum class SolveStage { preparing, solving, assessing, proving, listing, refining, done };

/// Who asked a solve to stop: the status that it ends with, and the reason in words.
struct StopCause {
  RunStatus status = RunStatus::stopped;
  std::string reason = "stopped on request";
};

/// What a solve may use of the outside; all of it may be empty.
struct SolveSurroundings {
  std::stop_token stop{};
  /// For proofs, where they are not to end with the solve; empty: `stop`.
  std::optional<std::stop_token> stop_proofs{};
  /// Asked after a stop, with the stage that it ended.
  std::function<StopCause(SolveStage)> why_stopped{};
  /// Hears of progress: what is being done in a few words, and the fraction in [0, 1] that is done, or a negative
  /// number when nobody can know. From any thread, one call at a time.
  std::function<void(std::string_view stage, double fraction)> progress{};
  /// Called when a stage begins, by the thread that solves. The library reads no clock; this is where others do.
  std::function<void(SolveStage)> entered{};
  Journal* journal = nullptr;
  Crew* crew = nullptr;
  StartStore* starts = nullptr;
};

/// Why `strategy`, made from `entry`, cannot do the scene: its own reason, or no sketch; nullopt when it can, be it without
/// the orientations of the scene (unoriented_scene.hpp).
std::optional<std::string> why_not(const StrategyEntry& entry, const Strategy& strategy,
                                   const SolveRequest& request);

/// Runs the strategy until it ends or is stopped. A strategy that throws has given up: it has a defect, or the
/// machine has no memory left. Throws OptionError for options and settings that are not allowed, and what is wrong
/// with files that the options name.
Answer solve(const Scene& scene, const StrategyEntry& entry, const OptionMap& given,
             const SolveSettings& settings = {}, const SolveSurroundings& surroundings = {});

/// The same with a strategy of this build, by name. Throws OptionError, too, for a name that none has.
Answer solve(const Scene& scene, std::string_view strategy, const OptionMap& given = {},
             const SolveSettings& settings = {}, const SolveSurroundings& surroundings = {});

/// The same with typed options, `solve(problem, Monodromy{.seed = 1, .certify = true})`: seed, threads and
/// certify are those of `strategy`, the other settings as given. Throws OptionError for values out of range.
template <StrategyOptions Options>
Answer solve(const Scene& scene, const Options& strategy, SolveSettings settings = {},
             const SolveSurroundings& surroundings = {}) {
  settings.seed = strategy.seed;
  settings.threads = strategy.threads;
  settings.certify = strategy.certify;
  return solve(scene, Options::strategy, options_of(strategy), settings, surroundings);
}

}  // namespace gcs
