#pragma once
/// One line on standard error that shows how far a solve has come and how long it may take.

#include <chrono>
#include <string_view>

#include "harness/time_left.hpp"
#include "solvers/strategy.hpp"

namespace gcs {

/// Shows progress when standard error is a terminal and `wanted`; otherwise nothing. Clears its line at the
/// end.
class ProgressLine final : public Monitor {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine() override;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void progress(std::string_view stage, double fraction) override;

 private:
  bool shown_ = false;    ///< somebody sees the line
  bool written_ = false;  ///< there is something to clear
  std::chrono::steady_clock::time_point next_;
  TimeLeft time_left_;
};

}  // namespace gcs
