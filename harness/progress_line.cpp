#include "harness/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace gcs {

namespace {

/// Often enough to look alive, seldom enough to cost nothing.
constexpr std::chrono::milliseconds interval{100};
constexpr std::string_view clear_line = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : shown_(wanted && isatty(STDERR_FILENO) == 1), next_(std::chrono::steady_clock::now() + interval) {}

ProgressLine::~ProgressLine() {
  if (written_) std::cerr << clear_line << std::flush;
}

void ProgressLine::progress(std::string_view stage, double fraction) {
  if (!shown_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + interval;
  written_ = true;
  const std::string share = fraction >= 0 ? fmt::format(" {:.0f} %", 100 * fraction) : "";
  const double now_s = std::chrono::duration<double>(now.time_since_epoch()).count();
  const std::optional<double> left_s = time_left_.estimate(stage, fraction, now_s);
  const std::string left = left_s ? ", " + rough_time(*left_s) + " left at this rate" : "";
  std::cerr << clear_line << stage << share << left << std::flush;
}

}  // namespace gcs
