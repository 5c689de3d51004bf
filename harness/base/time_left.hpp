#pragma once
/// How long a computation will still take, judged by how fast it has gone of late.

#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace gcs {

class TimeLeft {
 public:
  /// What follows a colon in `stage` says what is done at the moment, and makes no new stage. `fraction` in
  /// [0, 1] of it is done at `now_s`, in seconds of any clock that only goes forward. The seconds left at the
  /// rate of the last minute (or of the time between two reports, where that is longer), so that steps
  /// recalled from a journal do not count for long. Nothing while there is no rate: at the beginning of a
  /// stage, and where no fraction is known (negative) or nothing has moved.
  std::optional<double> estimate(std::string_view stage, double fraction, double now_s);

 private:
  struct Report {
    double fraction = 0;
    double time_s = 0;
  };

  std::string stage_;
  std::deque<Report> reports_;  ///< of the stage, the oldest first
};

/// "about 40 s", "about 3 min", "about 2.5 h"
std::string rough_time(double seconds);

}  // namespace gcs
