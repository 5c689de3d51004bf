#pragma once
/// Asks a running solve to stop: when its time is up, or when the user presses Ctrl-C.

#include <atomic>
#include <optional>
#include <stop_token>
#include <thread>

namespace gcs {

/// From now on the first SIGINT or SIGTERM is remembered instead of ending the process; a second one ends it.
void catch_interrupts();

/// True once a signal has arrived. It stays true: whoever runs several solves stops between two of them.
bool interrupted();

/// Watches while it lives. Every watch that lives or starts after an interrupt asks for stop at once.
class StopWatch {
 public:
  enum class Cause { none, time_limit, interrupt };

  /// `time_limit_s`: counted from now; empty: no limit. Throws std::system_error when the system has no
  /// thread or pipe left.
  explicit StopWatch(std::optional<double> time_limit_s);
  ~StopWatch();
  StopWatch(const StopWatch&) = delete;
  StopWatch& operator=(const StopWatch&) = delete;

  std::stop_token token() const { return source_.get_token(); }
  /// Why stop was asked for, or none.
  Cause cause() const { return cause_; }

 private:
  void watch(std::optional<double> time_limit_s);

  std::stop_source source_;
  std::atomic<Cause> cause_ = Cause::none;
  int end_of_watch_[2] = {-1, -1};  ///< a pipe: closing its writing end wakes the thread
  std::thread thread_;
};

}  // namespace gcs
