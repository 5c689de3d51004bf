#pragma once
/// The theoretical counts of a problem, found when they are first asked for, and once.

#include <mutex>
#include <optional>

#include "solvers/counting/theoretical_counts.hpp"

namespace gcs {

/// May be asked from any thread. The problem outlives it.
class CountsOnce {
 public:
  explicit CountsOnce(const ProblemStatement& problem) : problem_(problem) {}

  const TheoreticalCounts& get() const {
    std::call_once(once_, [this] { counts_ = theoretical_counts(problem_); });
    return *counts_;
  }

 private:
  const ProblemStatement& problem_;
  mutable std::once_flag once_;
  mutable std::optional<TheoreticalCounts> counts_;
};

}  // namespace gcs
