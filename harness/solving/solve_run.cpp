#include "harness/solving/solve_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <time.h>

#include <chrono>

#include "harness/base/stop_conditions.hpp"
#include "harness/solving/start_file.hpp"

namespace gcs {

namespace {

using Clock = std::chrono::steady_clock;

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of this process and of external programs that have ended.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  rusage programs{};
  getrusage(RUSAGE_CHILDREN, &programs);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) +
         seconds(programs.ru_utime) + seconds(programs.ru_stime);
}

/// Reads the clocks where a solve goes from one stage to the next.
class StageTimer {
 public:
  explicit StageTimer(Timing& timing) : timing_(timing) {}

  void enter(SolveStage stage) {
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    switch (stage_) {
      case SolveStage::preparing:
        timing_.prepare_s = elapsed_s;
        break;
      case SolveStage::solving:
        timing_.wall_s = elapsed_s;
        timing_.cpu_s = cpu_seconds() - cpu_start_;
        break;
      case SolveStage::proving:
        timing_.certify_s = elapsed_s;
        break;
      case SolveStage::refining:
        timing_.refine_s = elapsed_s;
        break;
      default:
        break;
    }
    stage_ = stage;
    if (stage == SolveStage::solving) cpu_start_ = cpu_seconds();
    start_ = Clock::now();
  }

 private:
  Timing& timing_;
  SolveStage stage_ = SolveStage::done;
  Clock::time_point start_ = Clock::now();
  double cpu_start_ = 0;
};

StopCause in_words(StopWatch::Cause cause, const RunLimits& limits) {
  if (cause == StopWatch::Cause::interrupt) return {RunStatus::interrupted, "interrupted by a signal"};
  return {RunStatus::timed_out,
          fmt::format("the time limit of {} s has passed", limits.time_limit_s.value_or(0))};
}

}  // namespace

SolveRun run_strategy(const StrategyEntry& entry, const OptionMap& given, const Scene& scene,
                      const RunLimits& limits, const RunServices& services) {
  SolveRun run;
  StopWatch watch(limits.time_limit_s);
  const StopWatch unlimited(std::nullopt);
  const StopWatch& proof_watch = limits.limits_proofs ? watch : unlimited;
  StartFiles starts;
  StageTimer timer(run.timing);
  SolveSurroundings surroundings{
      .stop = watch.token(),
      .stop_proofs = proof_watch.token(),
      .why_stopped =
          [&](SolveStage stage) {
            return in_words((stage == SolveStage::proving ? proof_watch : watch).cause(), limits);
          },
      .entered = [&](SolveStage stage) { timer.enter(stage); },
      .journal = services.journal,
      .crew = services.crew,
      .starts = &starts};
  if (services.monitor != nullptr)
    surroundings.progress = [&](std::string_view stage, double fraction) {
      services.monitor->progress(stage, fraction);
    };
  static_cast<Answer&>(run) = solve(scene, entry, given, limits, surroundings);
  return run;
}

}  // namespace gcs
