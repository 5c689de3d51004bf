#pragma once
/// Whether a path strategy jumps between arcs of S: smaller steps must give the same solutions, and another
/// strategy on the same S too.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solvers/answers/assess.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Options under which a strategy is run, and a name for them.
struct StepBound {
  std::string name;
  OptionMap options;
};

/// The default (a largest step of 1 in the scene's unit), and a quarter and a sixteenth of it.
std::vector<StepBound> default_step_bounds();

struct BoundedRun {
  std::string strategy;
  std::string bound;
  OptionMap options;  ///< every option, defaults included
  SolveReport report;
  Assessment assessment;

  bool complete() const { return report.status == SolveStatus::complete; }
  /// Arc length of S in the strategy's own coordinates.
  double length() const { return report.paths.empty() ? 0 : report.paths.front().length; }
};

struct StepBoundVerdict {
  std::vector<BoundedRun> runs;          ///< strategy by strategy, each in the order of the bounds
  std::size_t solutions = 0;             ///< classes on S, as the first complete run found them
  std::vector<std::string> unfinished;   ///< one sentence per run that is not complete
  std::vector<std::string> differences;  ///< one sentence per complete run that differs or fails a check

  bool agrees() const { return unfinished.empty() && differences.empty(); }
  /// All sentences, one a line.
  std::string explanation() const;
};

/// Runs full-space and rcp at every bound; `time_limit_s` is for one run. One strategy starts in the same
/// direction at all bounds: it must meet the same solutions in the same order, and its path must have the
/// same length, which also tells of jumps on the way. The strategies may start in opposite directions, and
/// where the frame of one turns over on a round (in space) that one needs two rounds to be back: their orders
/// are compared as circles, in both directions, rounds divided out.
StepBoundVerdict check_step_bounds(const Scene& scene, std::span<const StepBound> bounds,
                                   std::optional<double> time_limit_s = std::nullopt);

}  // namespace gcs
