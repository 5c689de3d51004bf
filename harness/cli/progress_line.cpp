#include "harness/cli/progress_line.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <iostream>

namespace gcs {

namespace {

/// Often enough to look alive, seldom enough to cost nothing.
constexpr std::chrono::milliseconds interval{200};
constexpr std::string_view clear_line = "\r\x1b[K";

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

/// As much of the text as fits in one row, where its width is known: a longer one could not be cleared.
std::string_view fitting(std::string_view text) {
  winsize window{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || text.size() < window.ws_col)
    return text;
  std::size_t size = window.ws_col - 1U;
  const auto is_inside_character = [&] { return (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80; };
  while (size > 0 && is_inside_character()) --size;
  return text.substr(0, size);
}

}  // namespace

ProgressLine::ProgressLine(bool wanted, bool logged) {
  const bool is_seen = isatty(STDERR_FILENO) == 1;
  if (wanted && is_seen) drawing_ = std::jthread([this](const std::stop_token& stop) { keep_drawing(stop); });
  logs_ = wanted && logged && !is_seen;
}

ProgressLine::~ProgressLine() {
  if (!drawing_.joinable()) return;
  drawing_.request_stop();
  drawing_.join();
  if (written_) std::cerr << clear_line << std::flush;
}

void ProgressLine::progress(std::string_view stage, double fraction) {
  if (logs_) log(stage, fraction);
  if (!drawing_.joinable()) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
    next_estimate_ = now;
  }
  fraction_ = fraction;
  if (now < next_estimate_) return;
  next_estimate_ = now + interval;
  const std::optional<double> left_s = time_left_.estimate(stage, fraction, seconds(now.time_since_epoch()));
  end_.reset();
  if (left_s)
    end_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*left_s));
}

void ProgressLine::log(std::string_view stage, double fraction) {
  const std::lock_guard lock(mutex_);
  const std::size_t comma = stage.find(',');
  std::string line(stage.substr(0, comma));
  if (comma == std::string_view::npos && fraction >= 0)
    line += fmt::format(" {:.0f} %", 10 * std::floor(10 * fraction));
  if (line == logged_) return;
  logged_ = line;
  std::cerr << fmt::format("{:%H:%M:%S} {}\n", fmt::localtime(std::time(nullptr)), line) << std::flush;
}

void ProgressLine::keep_drawing(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  std::condition_variable_any never;
  while (!stop.stop_requested()) {
    never.wait_for(lock, stop, interval, [] { return false; });
    if (stop.stop_requested() || stage_.empty()) continue;
    written_ = true;
    std::cerr << clear_line << fitting(text(Clock::now())) << std::flush;
  }
}

std::string ProgressLine::text(Clock::time_point now) const {
  const std::string share = fraction_ >= 0 ? fmt::format(" {:.0f} %", 100 * fraction_) : "";
  if (!end_) return fmt::format("{}{}, {:.0f} s so far", stage_, share, seconds(now - stage_start_));
  const double left_s = std::max(0.0, seconds(*end_ - now));
  return fmt::format("{}{}, {} left at this rate", stage_, share, rough_time(left_s));
}

}  // namespace gcs
