#pragma once
/// What a long computation tells the outside: progress while it runs, and counts of its work.

#include <cstdint>
#include <optional>
#include <string_view>

namespace gcs {

/// Hears of progress; never of results. Calls may come from any thread of the strategy, one at a time.
class Monitor {
 public:
  virtual ~Monitor() = default;
  /// `stage`: what is being done, a few words. `fraction` in [0, 1], or negative when nobody can know.
  virtual void progress(std::string_view stage, double fraction) = 0;
};

/// Deterministic counts of work: equal for equal input, seed and options, whatever the machine or thread
/// count.
struct WorkCounters {
  std::int64_t iterations = 0;  ///< accepted steps, the closing one included
  std::int64_t rejected_steps = 0;
  std::int64_t newton_iterations = 0;
  std::int64_t evaluations = 0;          ///< of the residual (or of a whole plan)
  std::int64_t partial_evaluations = 0;  ///< of a plan from a later instruction on
  std::int64_t jacobians = 0;
  std::int64_t factorisations = 0;
  std::int64_t plan_changes = 0;
  std::optional<double> smallest_step;            ///< of the accepted steps
  std::optional<double> mean_driving_parameters;  ///< over the accepted steps
  std::optional<int> max_driving_parameters;
};

/// Adds the work of another computation. Driving parameters stay those of `work`.
void add(const WorkCounters& more, WorkCounters& work);

}  // namespace gcs
