#pragma once
/// When an exact count gives up.

#include <cstdint>
#include <stop_token>

namespace gcs {

/// A step is a decision of a search, with all that follows from it: a microsecond or two.
struct RecursionLimits {
  std::int64_t steps = 4'000'000;  ///< some seconds: enough for all graphs of 18 points that have been tried
  std::stop_token stop = {};
};

/// What is left of them.
class StepsLeft {
 public:
  explicit StepsLeft(const RecursionLimits& limits) : steps_(limits.steps), stop_(limits.stop) {}

  /// Takes a step. False when there are none left, from then on always.
  bool take() {
    if (stop_.stop_requested()) steps_ = 0;
    return --steps_ >= 0;
  }
  bool are_exceeded() const { return steps_ < 0; }

 private:
  std::int64_t steps_;
  std::stop_token stop_;
};

}  // namespace gcs
