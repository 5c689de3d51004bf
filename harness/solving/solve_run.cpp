#include "harness/solving/solve_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <time.h>

#include <array>
#include <chrono>
#include <exception>
#include <utility>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/solving/counts_view.hpp"
#include "harness/solving/start_file.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/reading/json_document.hpp"

namespace gcs {

namespace {

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

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

SolveReport timed_solve(Strategy& strategy, const SolveRequest& request, Timing& timing) {
  const auto prepare_start = std::chrono::steady_clock::now();
  strategy.prepare(request);
  timing.prepare_s = seconds_since(prepare_start);
  const double cpu_start = cpu_seconds();
  const auto start = std::chrono::steady_clock::now();
  SolveReport report = strategy.solve(request);
  timing.wall_s = seconds_since(start);
  timing.cpu_s = cpu_seconds() - cpu_start;
  return report;
}

/// A strategy that throws has a defect, or the machine has no memory left; neither may end a series of runs.
/// What is wrong with the user's files and options does.
SolveReport guarded_solve(Strategy& strategy, const SolveRequest& request, Timing& timing) {
  try {
    return timed_solve(strategy, request, timing);
  } catch (const InputError&) {
    throw;
  } catch (const OutputError&) {
    throw;
  } catch (const OptionError&) {
    throw;
  } catch (const std::exception& error) {
    SolveReport report;
    report.reason = fmt::format("the strategy failed with an exception: {}", error.what());
    return report;
  }
}

void set_stopped(SolveRun& run, StopWatch::Cause cause, const RunLimits& limits) {
  switch (cause) {
    case StopWatch::Cause::interrupt:
      run.status = RunStatus::interrupted;
      run.reason = "interrupted by a signal";
      return;
    case StopWatch::Cause::time_limit:
      run.status = RunStatus::timed_out;
      run.reason = fmt::format("the time limit of {} s has passed", limits.time_limit_s.value_or(0));
      return;
    case StopWatch::Cause::none:
      run.status = RunStatus::gave_up;
      run.reason = "the strategy stopped without being asked to";
      return;
  }
}

void set_status(SolveRun& run, const SolveReport& report, StopWatch::Cause cause, const RunLimits& limits) {
  run.reason = report.reason;
  switch (report.status) {
    case SolveStatus::complete:
      run.status = RunStatus::complete;
      return;
    case SolveStatus::partial:
      run.status = RunStatus::partial;
      return;
    case SolveStatus::infinite:
      run.status = RunStatus::infinite;
      return;
    case SolveStatus::gave_up:
      run.status = RunStatus::gave_up;
      return;
    case SolveStatus::stopped:
      set_stopped(run, cause, limits);
      return;
  }
}

void limit_solutions(SolveRun& run, std::size_t limit) {
  const std::size_t found = run.assessment.solutions.size();
  if (found <= limit) return;
  keep_first(run.assessment, limit);
  if (run.status != RunStatus::complete) return;
  run.status = RunStatus::partial;
  run.reason = fmt::format("{} of the {} solutions found are kept, as asked", limit, found);
}

/// Of a product, not all are listed. `are_distinct`: in doubles, what is listed is.
void note_unlisted(SolveRun& run, bool are_distinct) {
  const std::optional<SolutionTotals>& totals = run.assessment.totals;
  if (!totals || run.status != RunStatus::complete) return;
  const std::optional<Natural>& all = totals->complex ? totals->complex : totals->real;
  const std::size_t listed = run.assessment.solutions.size();
  if (!all || *all == Natural(listed)) return;
  run.status = RunStatus::partial;
  run.reason = fmt::format("{} of the {} solutions are listed; {}", listed, readable(*all),
                           are_distinct ? "--max-solutions lists more" : "doubles do not tell all apart");
}

/// Of a solve that was stopped, all that it found is certified, and its monitor has heard the last of it.
void certify_solutions(const Scene& scene, const TheoreticalCounts& counts, const SolveReport& report,
                       const StopWatch& solve_watch, const RunLimits& limits, Monitor* monitor,
                       SolveRun& run) {
  const auto start = std::chrono::steady_clock::now();
  const bool was_stopped = solve_watch.cause() != StopWatch::Cause::none;
  const StopWatch unlimited(std::nullopt);
  const StopWatch& watch = limits.limits_proofs ? solve_watch : unlimited;
  certify(scene, counts, report.generic_member, run.threads, was_stopped ? nullptr : monitor, run.assessment,
          was_stopped ? std::stop_token() : watch.token());
  run.timing.certify_s = seconds_since(start);
  if (was_stopped || watch.cause() == StopWatch::Cause::none) return;
  set_stopped(run, watch.cause(), limits);
  run.reason += " while solutions were proven";
}

/// What is left of all complex solutions are all real ones.
void leave_out_complex(SolveRun& run) {
  keep_real(run.assessment);
  if (run.claim == Claim::all_complex) run.claim = Claim::all_real;
}

/// No isolated solutions are more than the theoretical count, and at generic lengths they are as many as the
/// exact one. Only of complete answers: others say themselves what is wrong with them.
void check_counts(const TheoreticalCounts& limits, SolveRun& run) {
  const SolutionCount* limit = limits.upper_limit();
  if (limit == nullptr || run.status != RunStatus::complete) return;
  const Natural most = limit->up_to_reflection();
  const auto fail = [&](std::string_view what, const Natural& count) {
    run.assessment.failed_checks.push_back(
        {"count", fmt::format("{} {} up to reflection, and the {} is {}", count.decimal(), what,
                              limits.exact ? "exact number" : "upper bound", most.decimal())});
  };
  const std::optional<Natural>& generic = run.assessment.counts.generic;
  const bool is_right = !generic || (limits.exact ? *generic == most : *generic <= most);
  if (!is_right) fail("solutions at generic lengths", *generic);
  Natural solutions;
  for (const AssessedSolution& solution : run.assessment.solutions)
    solutions += Natural(static_cast<std::uint64_t>(solution.multiplicity));
  if (run.assessment.totals)
    solutions = std::max(solutions, run.assessment.totals->complex.value_or(solutions));
  if (most < solutions) fail("solutions, counted with multiplicities,", solutions);
}

/// Where certificates do not reach the scene nothing is refined.
void refine_solutions(const Scene& scene, int digits, const StopWatch& watch, const RunLimits& limits,
                      SolveRun& run) {
  if (why_not_certified(scene)) return;
  const auto start = std::chrono::steady_clock::now();
  std::vector<Figure> figures;
  for (const AssessedSolution& solution : run.assessment.solutions)
    figures.push_back(scene.in_scene_unit(solution.figure));
  run.refined = decimal_figures(SceneEquations(scene), scene, figures, digits, run.threads, watch.token());
  run.timing.refine_s = seconds_since(start);
  if (watch.cause() != StopWatch::Cause::none) set_stopped(run, watch.cause(), limits);
}

}  // namespace

std::string_view word(RunStatus status) {
  constexpr std::array<std::string_view, 7> words{"complete", "partial",     "infinite", "unsupported",
                                                  "gave up",  "interrupted", "timed out"};
  return words[static_cast<std::size_t>(status)];
}

std::string_view word(Claim claim) {
  constexpr std::array<std::string_view, 5> words{"some real", "on path", "on path of the core", "all real",
                                                  "all complex"};
  return words[static_cast<std::size_t>(claim)];
}

std::optional<std::string> why_not(const StrategyEntry& entry, const Strategy& strategy, const Scene& scene) {
  if (auto reason = strategy.why_unsupported(scene)) return reason;
  if (entry.needs_sketch && !scene.sketch()) return "it starts at a sketch, and the instance gives none";
  return std::nullopt;
}

SolveRun run_strategy(const StrategyEntry& entry, const OptionMap& given, const Scene& scene,
                      const RunLimits& limits, const RunServices& services) {
  SolveRun run;
  run.strategy = entry.name;
  run.options = complete_options(entry, given);
  run.seed = limits.seed;
  run.threads = limits.threads;
  const auto strategy = entry.make(run.options);
  if (auto reason = why_not(entry, *strategy, scene)) {
    run.status = RunStatus::unsupported;
    run.reason = std::move(*reason);
    return run;
  }
  StopWatch watch(limits.time_limit_s);
  StartFiles starts;
  const SolveRequest request{scene,         limits.seed,         limits.threads,
                             watch.token(), services.monitor,    services.journal,
                             &starts,       limits.max_solutions};
  SolveReport report = guarded_solve(*strategy, request, run.timing);
  set_status(run, report, watch.cause(), limits);
  run.claim = report.claim;
  run.assessment = assess(scene, report);
  const bool are_distinct = run.assessment.solutions.size() == report.candidates.size();
  if (limits.checks_counts || limits.certify) {
    const TheoreticalCounts counts = theoretical_counts(scene.problem());
    if (limits.checks_counts) check_counts(counts, run);
    if (limits.certify) certify_solutions(scene, counts, report, watch, limits, services.monitor, run);
  }
  if (limits.only_real) leave_out_complex(run);
  if (limits.max_solutions) limit_solutions(run, *limits.max_solutions);
  note_unlisted(run, are_distinct);
  if (limits.digits > 0) refine_solutions(scene, limits.digits, watch, limits, run);
  run.work = report.work;
  run.particulars = std::move(report.particulars);
  return run;
}

}  // namespace gcs
