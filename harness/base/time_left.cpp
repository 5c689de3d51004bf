#include "harness/base/time_left.hpp"

#include <fmt/format.h>

namespace gcs {

namespace {

constexpr double window_s = 60;
/// A rate measured over less is chance.
constexpr double shortest_s = 2;

}  // namespace

std::optional<double> TimeLeft::estimate(std::string_view stage, double fraction, double now_s) {
  stage = stage.substr(0, stage.find(':'));
  if (stage != stage_) reports_.clear();
  stage_ = stage;
  if (fraction < 0) return std::nullopt;
  reports_.push_back({fraction, now_s});
  while (reports_.size() > 2 && reports_[1].time_s <= now_s - window_s) reports_.pop_front();
  const double time_s = now_s - reports_.front().time_s;
  const double done = fraction - reports_.front().fraction;
  if (time_s < shortest_s || !(done > 0)) return std::nullopt;
  return (1 - fraction) * time_s / done;
}

std::string rough_time(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 1.5 * minute) return fmt::format("about {:.0f} s", seconds);
  if (seconds < 1.5 * hour) return fmt::format("about {:.0f} min", seconds / minute);
  return fmt::format("about {:.1f} h", seconds / hour);
}

}  // namespace gcs
