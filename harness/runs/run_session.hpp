#pragma once
/// One start of the program that measured for a run.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gcs {

/// A run that was stopped and resumed has several.
struct RunSession {
  std::string started;                 ///< UTC, ISO 8601
  std::vector<std::string> arguments;  ///< the words of the command line, that of the program first
  std::string folder;                  ///< in which the program was started
  /// Processes that wanted to run in the last 1, 5 and 15 minutes, when the session started; empty: the
  /// system does not say.
  std::optional<std::array<double, 3>> load_average;
  std::optional<int> repetitions;       ///< asked for; empty: as many as the budget allows
  double budget_s = 0;                  ///< for all repetitions together
  std::optional<double> cell_limit_s;   ///< for one solve
  std::optional<double> total_limit_s;  ///< for the session
};

/// The session that starts now; `arguments` are passed on, and limits left to the caller.
RunSession start_session(const std::vector<std::string>& arguments);

}  // namespace gcs
