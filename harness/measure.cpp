#include "harness/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "harness/agreement.hpp"
#include "harness/solve_run.hpp"
#include "harness/stop_conditions.hpp"
#include "harness/time_left.hpp"

namespace gcs {
namespace {

/// Below three no median is worth its name; above a hundred the interval hardly narrows.
constexpr int fewest_repetitions = 3;
constexpr int most_repetitions = 101;

using Clock = std::chrono::steady_clock;

/// How much time is left for everything.
class TimeBudget {
 public:
  explicit TimeBudget(const MeasureSettings& settings)
      : start_(Clock::now()),
        total_s_(settings.limits.total_limit_s),
        cell_s_(settings.limits.cell_limit_s) {}

  bool none() const { return total_s_ && remaining_s() <= 0; }

  /// The limit of the next solve.
  std::optional<double> for_one_solve() const {
    if (!total_s_) return cell_s_;
    return std::min(cell_s_.value_or(remaining_s()), remaining_s());
  }

 private:
  double remaining_s() const {
    return *total_s_ - std::chrono::duration<double>(Clock::now() - start_).count();
  }

  Clock::time_point start_;
  std::optional<double> total_s_;
  std::optional<double> cell_s_;
};

/// A cell on its way: its record, and what one solve costs.
struct Work {
  const MeasureTask* task;
  CellRecord record;
  double cost_s = 0;
  int planned = 0;  ///< repetitions
};

/// True when nothing is left to measure of the cell.
bool is_finished(const MeasureTask& task, const CellRecord& cell) {
  if (task.keeps_solutions && cell.is_right() && cell.solutions.empty()) return false;
  if (cell.is_right()) return cell.repetitions.size() >= fewest_repetitions;
  return cell.status != RunStatus::interrupted && cell.status != RunStatus::timed_out;
}

/// Hears how far a solve has come, for an estimate of what it would take.
class SolveEstimate final : public Monitor {
 public:
  void progress(std::string_view stage, double fraction) override {
    const double now_s = std::chrono::duration<double>(Clock::now() - start_).count();
    const std::optional<double> left_s = time_left_.estimate(stage, fraction, now_s);
    if (left_s || stage != stage_) total_s_ = left_s ? std::optional(now_s + *left_s) : std::nullopt;
    stage_ = stage;
  }

  /// What the solve is at.
  const std::string& stage() const { return stage_; }
  /// Until the end of this stage.
  std::optional<double> total_s() const { return total_s_; }

 private:
  Clock::time_point start_ = Clock::now();
  TimeLeft time_left_;
  std::string stage_;
  std::optional<double> total_s_;
};

/// `limits`: what is asked for beside the settings.
SolveRun solve_once(const MeasureTask& task, const MeasureSettings& settings, const TimeBudget& left,
                    RunLimits limits = {}, Monitor* monitor = nullptr) {
  limits.seed = settings.seed;
  limits.threads = settings.threads;
  limits.time_limit_s = left.for_one_solve();
  limits.digits = task.spec.digits;
  return run_strategy(*task.entry, task.spec.given, *task.scene, limits, {monitor});
}

double largest_residual(const Assessment& assessment) {
  double largest = 0;
  for (const AssessedSolution& solution : assessment.solutions)
    largest = std::max(largest, solution.residual);
  return largest;
}

RecordedSolution recorded(const Problem& problem, const AssessedSolution& solution) {
  RecordedSolution record{solution.figure.is_real(), solution.multiplicity, {}};
  if (!record.is_real) return record;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Eigen::Vector3d point = solution.figure.points.col(static_cast<Eigen::Index>(i));
    record.points[problem.points[i]] = {point.x(), point.y(), point.z()};
  }
  return record;
}

/// Repetitions are not certified again: their counts are compared with what the strategy found alone.
void take_proofs(const Assessment& assessment, CellRecord& record) {
  record.counts.certified.reset();
  if (!assessment.proofs || assessment.proofs->why_none) return;
  const Proofs& proofs = *assessment.proofs;
  record.proofs = RecordedProofs{proofs.classes, proofs.real, proofs.are_complete(), proofs.decide_real()};
}

CellRecord record_of(const MeasureTask& task, const SolveRun& run) {
  CellRecord record;
  record.spec = task.spec;
  record.options = run.options;
  record.status = run.status;
  record.reason = run.reason;
  record.counts = run.assessment.counts;
  record.work = run.work;
  record.particulars = run.particulars;
  record.residual = largest_residual(run.assessment);
  if (task.keeps_solutions)
    for (const AssessedSolution& solution : run.assessment.solutions)
      record.solutions.push_back(recorded(task.scene->problem(), solution));
  for (const FailedCheck& check : run.assessment.failed_checks) {
    if (check.name == "singular") continue;  // out of the reach of certificates, and said so by their number
    record.difference += (record.difference.empty() ? "" : " ") + check.what;
  }
  take_proofs(run.assessment, record);
  record.claim = run.claim;
  const bool is_answer = run.status == RunStatus::complete || run.status == RunStatus::partial;
  if (task.judge != nullptr && is_answer) record.accuracy = task.judge->judge(run, task.spec.digits);
  return record;
}

CellRecord not_run(const CellSpec& spec, std::string_view why) {
  CellRecord record;
  record.spec = spec;
  record.status = RunStatus::timed_out;
  record.reason = fmt::format("not run: {}", why);
  return record;
}

/// Whether the same strategy with its defaults has already been too slow for the instance.
bool has_slow_default(const CellSpec& spec, const std::vector<Work>& earlier) {
  return std::any_of(earlier.begin(), earlier.end(), [&](const Work& work) {
    const CellSpec& other = work.record.spec;
    return other.instance == spec.instance && other.strategy == spec.strategy && other.given.empty() &&
           other.digits == 0 && work.record.status == RunStatus::timed_out;
  });
}

/// For a solve that was stopped on its way.
void set_estimate(const SolveEstimate& estimate, double elapsed_s, CellRecord& record) {
  if (estimate.total_s() > elapsed_s) record.estimate_s = estimate.total_s();
  if (!estimate.stage().empty()) record.reason += fmt::format(", at \"{}\"", estimate.stage());
  record.reason += record.estimate_s ? "; the estimate is for the way to the end of that" : "";
  record.reason += "; --full has no limit";
}

Work warm_up(const MeasureTask& task, const MeasureSettings& settings, const TimeBudget& left) {
  if (left.none()) return {&task, not_run(task.spec, "the time for the whole measurement is used up")};
  SolveEstimate estimate;
  RunLimits limits;
  limits.certify = task.judge == nullptr;
  const SolveRun run = solve_once(task, settings, left, limits, &estimate);
  Work work{&task, record_of(task, run), run.timing.prepare_s + run.timing.wall_s + run.timing.refine_s};
  if (run.status == RunStatus::timed_out) set_estimate(estimate, work.cost_s, work.record);
  return work;
}

/// Why a repetition is not the same answer as the warm-up; empty: it is.
std::string changed_answer(const CellRecord& first, const SolveRun& run) {
  if (run.status != first.status)
    return fmt::format("A repetition ended as '{}': {}", word(run.status), run.reason);
  if (run.assessment.counts != first.counts || run.work.iterations != first.work.iterations ||
      run.particulars != first.particulars) {
    return "A repetition with the same seed gave another answer.";
  }
  return "";
}

void repeat(Work& work, const MeasureSettings& settings, const TimeBudget& left) {
  RunLimits limits;
  limits.checks_counts = false;  // they are those of the warm-up
  const SolveRun run = solve_once(*work.task, settings, left, limits);
  if (run.status == RunStatus::interrupted || run.status == RunStatus::timed_out) return;
  work.record.difference = changed_answer(work.record, run);
  if (work.record.is_right()) {
    work.record.repetitions.push_back(
        {run.timing.prepare_s, run.timing.wall_s, run.timing.cpu_s, run.timing.refine_s});
  } else {
    work.record.repetitions.clear();
  }
}

/// Shares the budget out equally, cheapest cells first: what they cannot use goes to the dearer ones.
void plan_repetitions(std::vector<Work>& cells, const MeasureSettings& settings) {
  std::vector<Work*> open;
  for (Work& work : cells) {
    if (work.record.is_right() && work.record.repetitions.empty()) open.push_back(&work);
  }
  std::sort(open.begin(), open.end(), [](const Work* a, const Work* b) { return a->cost_s < b->cost_s; });
  double budget_s = settings.limits.budget_s;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const double affordable =
        budget_s / static_cast<double>(open.size() - i) / std::max(open[i]->cost_s, 1e-9);
    const double bounded = std::clamp<double>(affordable, fewest_repetitions, most_repetitions);
    open[i]->planned = settings.repetitions.value_or(static_cast<int>(bounded));
    budget_s = std::max(0.0, budget_s - open[i]->planned * open[i]->cost_s);
  }
}

/// True when a cell with `planned` of `rounds` repetitions takes its turn: turns are spread evenly over the
/// rounds.
bool has_turn(int planned, int round, int rounds) {
  const auto through = [&](int r) { return static_cast<std::int64_t>(r) * planned / rounds; };
  return through(round + 1) > through(round);
}

std::vector<CellRecord> records_of(const std::vector<Work>& cells) {
  std::vector<CellRecord> records;
  records.reserve(cells.size());
  for (const Work& work : cells) records.push_back(work.record);
  return records;
}

/// Progress as ProgressLine wants it.
double share(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

std::vector<Work> warm_up_all(std::span<const MeasureTask> tasks, const MeasureSettings& settings,
                              const std::vector<CellRecord>& known, const TimeBudget& left, Monitor& progress,
                              const MeasureCheckpoint& checkpoint) {
  std::vector<Work> cells;
  for (const MeasureTask& task : tasks) {
    if (interrupted()) break;
    const auto earlier = std::find_if(known.begin(), known.end(), [&](const CellRecord& c) {
      return c.spec == task.spec && is_finished(task, c);
    });
    if (earlier != known.end()) {
      cells.push_back({&task, *earlier});
      continue;
    }
    if (settings.limits.skips_variants && has_slow_default(task.spec, cells)) {
      cells.push_back(
          {&task, not_run(task.spec, "the strategy's defaults already take too long; --full has no limit")});
      continue;
    }
    progress.progress(task.spec.instance + ", " + task.spec.strategy, share(cells.size(), tasks.size()));
    cells.push_back(warm_up(task, settings, left));
    checkpoint(records_of(cells));
  }
  return cells;
}

void repeat_all(std::vector<Work>& cells, const MeasureSettings& settings, const TimeBudget& left,
                Monitor& progress, const MeasureCheckpoint& checkpoint) {
  plan_repetitions(cells, settings);
  int rounds = 0;
  for (const Work& work : cells) rounds = std::max(rounds, work.planned);
  for (int round = 0; round < rounds; ++round) {
    progress.progress("repetitions", share(round, rounds));
    for (Work& work : cells) {
      if (interrupted() || left.none()) return;
      if (work.record.is_right() && has_turn(work.planned, round, rounds)) repeat(work, settings, left);
    }
    checkpoint(records_of(cells));
  }
}

}  // namespace

std::vector<CellRecord> measure(std::span<const MeasureTask> tasks, const MeasureSettings& settings,
                                const std::vector<CellRecord>& known, Monitor& progress,
                                const MeasureCheckpoint& checkpoint) {
  const TimeBudget left(settings);
  std::vector<Work> cells = warm_up_all(tasks, settings, known, left, progress, checkpoint);
  std::vector<CellRecord> judged = records_of(cells);
  note_differences(judged, settings.expected);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].record = judged[i];
  repeat_all(cells, settings, left, progress, checkpoint);
  return records_of(cells);
}

}  // namespace gcs
