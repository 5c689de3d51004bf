#pragma once
/// One line on standard error that shows how far a solve has come and how long it may take.

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "harness/base/time_left.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Shows progress when standard error is a terminal and `wanted`; otherwise nothing, or a log. The line lives
/// between reports too: it says how long a stage has taken so far, or how much time is left. Clears its line
/// at the end.
class ProgressLine final : public Monitor {
 public:
  /// `logged`: where there is no terminal, a line with the time of day for every stage, named up to its first
  /// comma, and for each tenth of one whose share is known.
  explicit ProgressLine(bool wanted, bool logged = false);
  ~ProgressLine() override;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void progress(std::string_view stage, double fraction) override;

 private:
  using Clock = std::chrono::steady_clock;

  void keep_drawing(const std::stop_token& stop);
  void log(std::string_view stage, double fraction);
  std::string text(Clock::time_point now) const;

  std::mutex mutex_;      ///< of all below but the thread
  bool written_ = false;  ///< there is something to clear
  std::string stage_;
  double fraction_ = -1;
  Clock::time_point stage_start_;
  Clock::time_point next_estimate_;
  std::optional<Clock::time_point> end_;  ///< of the stage, as estimated
  TimeLeft time_left_;
  bool logs_ = false;
  std::string logged_;    ///< the last line of the log, without its time
  std::jthread drawing_;  ///< runs while somebody sees the line
};

}  // namespace gcs
