#include "harness/python/watched_solve.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <utility>

#include "harness/solving/start_file.hpp"

namespace py = pybind11;

namespace gcs {
namespace {

using Clock = std::chrono::steady_clock;

/// How long Ctrl-C waits at most, and how often progress is shown.
constexpr std::chrono::milliseconds between_looks{50};

/// What a solve says of its progress, from any thread.
class SaidProgress {
 public:
  void set(std::string_view stage, double fraction) {
    const std::scoped_lock lock(mutex_);
    stage_ = stage;
    fraction_ = fraction;
  }
  std::pair<std::string, double> get() const {
    const std::scoped_lock lock(mutex_);
    return {stage_, fraction_};
  }

 private:
  mutable std::mutex mutex_;
  std::string stage_;
  double fraction_ = -1;
};

class Watch {
 public:
  Watch(std::optional<double> time_limit_s, py::object progress)
      : time_limit_s_(time_limit_s), progress_(std::move(progress)) {}

  /// Of the solve, which may run until it has read its stop token.
  SolveSurroundings surroundings() {
    SolveSurroundings result;
    result.stop = stop_.get_token();
    result.why_stopped = [this](SolveStage) { return cause(); };
    if (!progress_.is_none())
      result.progress = [this](std::string_view stage, double fraction) { said_.set(stage, fraction); };
    return result;
  }

  std::stop_token token() const { return stop_.get_token(); }
  StopCause cause() const {
    if (is_timed_out_)
      return {RunStatus::timed_out, fmt::format("the time limit of {} s has passed", *time_limit_s_)};
    return {RunStatus::interrupted, "interrupted"};
  }

  template <typename Result>
  Result wait_for(std::future<Result> result) {
    while (!is_done(result)) look();
    if (failure_) std::rethrow_exception(failure_);
    return result.get();
  }

 private:
  template <typename Result>
  static bool is_done(const std::future<Result>& result) {
    const py::gil_scoped_release unlocked;
    return result.wait_for(between_looks) == std::future_status::ready;
  }

  void look() {
    if (stop_.stop_requested()) return hear_signals();
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    if (time_limit_s_ && elapsed_s >= *time_limit_s_) {
      is_timed_out_ = true;
      stop_.request_stop();
    }
    hear_signals();
    if (!progress_.is_none() && !failure_) show_progress();
  }

  void hear_signals() {
    if (PyErr_CheckSignals() == 0) return;
    if (stop_.stop_requested() || !PyErr_ExceptionMatches(PyExc_KeyboardInterrupt)) {
      fail();
    } else {
      PyErr_Clear();
      stop_.request_stop();
    }
  }

  void show_progress() {
    try {
      const auto [stage, fraction] = said_.get();
      if (!stage.empty()) progress_(stage, fraction);
    } catch (py::error_already_set&) {
      failure_ = std::current_exception();
      stop_.request_stop();
    }
  }

  /// With the error that Python has set.
  void fail() {
    failure_ = std::make_exception_ptr(py::error_already_set());
    stop_.request_stop();
  }

  std::optional<double> time_limit_s_;
  py::object progress_;
  Clock::time_point start_ = Clock::now();
  std::stop_source stop_;
  std::atomic<bool> is_timed_out_ = false;
  SaidProgress said_;
  std::exception_ptr failure_;
};

}  // namespace

Answer watched_solve(const Scene& scene, const std::string& strategy, const OptionMap& options,
                     const SolveSettings& settings, std::optional<double> time_limit_s,
                     const py::object& progress) {
  Watch watch(time_limit_s, progress);
  SolveSurroundings surroundings = watch.surroundings();
  StartFiles starts;
  surroundings.starts = &starts;
  return watch.wait_for(std::async(std::launch::async,
                                   [&] { return solve(scene, strategy, options, settings, surroundings); }));
}

std::vector<Followed> watched_follow(const Scene& scene, const Figure& from,
                                     const std::vector<ChangedValues>& vertices,
                                     const FollowSettings& settings, std::optional<double> time_limit_s) {
  Watch watch(time_limit_s, py::none());
  std::vector<Followed> legs = watch.wait_for(std::async(
      std::launch::async, [&] { return follow_polyline(scene, from, vertices, settings, watch.token()); }));
  if (!legs.empty() && legs.back().end == ArcEnd::stopped) legs.back().reason = watch.cause().reason;
  return legs;
}

}  // namespace gcs
