#pragma once
/// The answer of a strategy to a scene: how the solve ended, and what it found, assessed in the same way for every
/// strategy.

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

/// How a solve ended. Everything but `complete` comes with a reason. The last two say who stopped it, where its
/// caller can tell.
enum class RunStatus { complete, partial, infinite, unsupported, gave_up, stopped, interrupted, timed_out };

/// The word of gcsbench-result/1: "complete", …, "gave up", "timed out".
std::string_view word(RunStatus status);
/// The word of gcsbench-result/1: "some real", "on path", …
std::string_view word(Claim claim);

/// The word of gcsbench-result/1: "in the given frame", "up to motion", "up to reflection".
std::string_view word(Convention convention);

/// The word of gcsbench-result/1: "as stated", "undecided", "not as stated".
std::string_view word(Standing standing);

inline constexpr std::array all_statuses{RunStatus::complete,    RunStatus::partial,  RunStatus::infinite,
                                         RunStatus::unsupported, RunStatus::gave_up,  RunStatus::stopped,
                                         RunStatus::interrupted, RunStatus::timed_out};
inline constexpr std::array all_claims{Claim::some_real,       Claim::on_path,
                                       Claim::on_path_of_core, Claim::all_real_of_component,
                                       Claim::all_real,        Claim::all_complex};
inline constexpr std::array all_conventions{Convention::in_the_given_frame, Convention::up_to_motion,
                                            Convention::up_to_reflection};
inline constexpr std::array all_standings{Standing::as_stated, Standing::undecided, Standing::not_as_stated};

/// How a solve was asked for, how it ended and what it took.
struct SolveOutcome {
  OptionMap options;  ///< every option of the strategy, defaults included
  RunStatus status = RunStatus::gave_up;
  std::string reason;          ///< empty when complete
  bool has_failed = false;     ///< by an exception of the strategy, a fault of the program
  std::optional<Claim> claim;  ///< empty when nothing was run
  WorkCounters work;
  std::vector<Particular> particulars;  ///< counts that only this strategy knows

  /// Compiled once.
  SolveOutcome();
  SolveOutcome(const SolveOutcome&);
  SolveOutcome(SolveOutcome&&) noexcept;
  SolveOutcome& operator=(const SolveOutcome&);
  SolveOutcome& operator=(SolveOutcome&&) noexcept;
  ~SolveOutcome();
};

/// One solution for each reflection class, how many there are, what is proven about them, and which checks
/// failed (see Assessment), with the outcome of the solve.
struct Answer : Assessment, SolveOutcome {
  std::string strategy;
  std::uint64_t seed = 1;
  int threads = 1;
  /// Of each solution, to the digits asked for; nothing where it is not proven to so many. Empty unless asked
  /// for.
  std::vector<std::optional<DecimalFigure>> refined;

  /// Compiled once.
  Answer();
  Answer(const Answer&);
  Answer(Answer&&) noexcept;
  Answer& operator=(const Answer&);
  Answer& operator=(Answer&&) noexcept;
  ~Answer();
};

}  // namespace gcs
