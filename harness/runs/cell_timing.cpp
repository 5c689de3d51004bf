#include "harness/runs/cell_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "harness/base/stop_conditions.hpp"
#include "harness/base/time_left.hpp"
#include "harness/runs/agreement.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {
namespace {

/// Below three no median is worth its name; above a hundred the interval hardly narrows.
constexpr int fewest_repetitions = 3;
constexpr int most_repetitions = 101;

using Clock = std::chrono::steady_clock;

/// So much of the repetitions is lost at most when the program is killed.
constexpr std::chrono::seconds storing_interval{1};

/// How much time is left for everything but references.
class TimeBudget {
 public:
  explicit TimeBudget(const TimingSettings& settings)
      : start_(Clock::now()),
        total_s_(settings.limits.total_limit_s),
        cell_s_(settings.limits.cell_limit_s) {}

  /// What has taken so long does not count.
  void leave_out(Clock::duration time) { start_ += time; }

  bool none() const { return total_s_ && remaining_s() <= 0; }

  /// Of one solve, at most.
  std::optional<double> cell_s() const { return cell_s_; }

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

/// A cell on its way.
struct Work {
  const CellTask* task;
  CellRecord record;
  int begun = 0;  ///< repetitions, those that were stopped included
};

/// True when the cell need not be solved again for its answer; `limit_s` is what a solve may take.
bool is_decided(const CellTask& task, const CellRecord& cell, std::optional<double> limit_s) {
  if (task.keeps_solutions && cell.is_right() && cell.solutions.empty()) return false;
  if (cell.status == RunStatus::timed_out) return cell.limit_s && limit_s && *cell.limit_s >= *limit_s;
  return cell.status != RunStatus::interrupted;
}

/// Passes on what is done for one cell, as a part of what is done for all of them.
class CellProgress final : public Monitor {
 public:
  CellProgress(Monitor& all, const CellSpec& spec, std::size_t number, std::size_t cells)
      : all_(all),
        name_(fmt::format("answers: {}, {}", spec.instance, spec.strategy)),
        before_(static_cast<double>(number)),
        cells_(static_cast<double>(cells)) {
    all_.progress(name_, before_ / cells_);
  }

  void progress(std::string_view stage, double fraction) override {
    all_.progress(fmt::format("{}: {}", name_, stage), (before_ + std::clamp(fraction, 0.0, 1.0)) / cells_);
  }

 private:
  Monitor& all_;
  std::string name_;
  double before_;
  double cells_;
};

/// Hears how far a solve has come, for an estimate of what it would take, and passes it on.
class SolveEstimate final : public Monitor {
 public:
  explicit SolveEstimate(Monitor& shown) : shown_(shown) {}

  void progress(std::string_view stage, double fraction) override {
    const double now_s = std::chrono::duration<double>(Clock::now() - start_).count();
    const std::optional<double> left_s = time_left_.estimate(stage, fraction, now_s);
    if (left_s || stage != stage_) total_s_ = left_s ? std::optional(now_s + *left_s) : std::nullopt;
    stage_ = stage;
    shown_.progress(stage, fraction);
  }

  /// What the solve is at.
  const std::string& stage() const { return stage_; }
  /// Until the end of this stage.
  std::optional<double> total_s() const { return total_s_; }

 private:
  Monitor& shown_;
  Clock::time_point start_ = Clock::now();
  TimeLeft time_left_;
  std::string stage_;
  std::optional<double> total_s_;
};

/// `limits`: what is asked for beside the settings.
SolveRun solve_once(const CellTask& task, const TimingSettings& settings, RunLimits limits,
                    Monitor* monitor = nullptr) {
  limits.seed = settings.seed;
  limits.threads = settings.threads;
  limits.digits = task.spec.digits;
  return run_strategy(*task.entry, task.spec.given, *task.scene, limits, {monitor});
}

double largest_residual(const Assessment& assessment) {
  double largest = 0;
  for (const AssessedSolution& solution : assessment.solutions)
    largest = std::max(largest, solution.residual);
  return largest;
}

RecordedSolution recorded(const ProblemStatement& problem, const AssessedSolution& solution) {
  RecordedSolution record{solution.is_real(), solution.multiplicity, {}};
  if (!record.is_real) return record;
  const Figure placement = solution.placement();
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Eigen::Vector3d point = placement.points.col(static_cast<Eigen::Index>(i));
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

bool proves_path(const SolveRun& run) {
  const auto is_proven = [](const PathEnds& ends) {
    return ends.proven && ends.end == PathRecord::End::closed;
  };
  return run.claim == Claim::on_path && !run.ends.empty() && std::ranges::all_of(run.ends, is_proven);
}

CellRecord record_of(const CellTask& task, const SolveRun& run, const AccuracyJudge* judge) {
  CellRecord record;
  static_cast<SolveOutcome&>(record) = run;
  record.spec = task.spec;
  record.counts = run.counts;
  record.residual = largest_residual(run);
  if (task.keeps_solutions)
    for (const AssessedSolution& solution : run.solutions)
      record.solutions.push_back(recorded(task.scene->problem(), solution));
  for (const FailedCheck& check : run.failed_checks) {
    if (check.name == "singular") continue;  // out of the reach of certificates, and said so by their number
    record.difference += (record.difference.empty() ? "" : " ") + check.what;
  }
  take_proofs(run, record);
  record.is_path_proven = proves_path(run);
  const bool is_answer = run.status == RunStatus::complete || run.status == RunStatus::partial;
  if (judge != nullptr && (is_answer || judge->is_search_in_vain(run)))
    record.accuracy = judge->judge(run, task.spec.digits);
  record.warm_up_s = run.timing.total_s();
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
void set_estimate(const SolveEstimate& estimate, CellRecord& record) {
  if (estimate.total_s() > record.warm_up_s) record.estimate_s = estimate.total_s();
  if (!estimate.stage().empty()) record.reason += fmt::format(", at \"{}\"", estimate.stage());
  record.reason += record.estimate_s ? "; the estimate is for the way to the end of that" : "";
  record.reason += "; --full has no limit";
}

CellRecord warm_up(const CellTask& task, const AccuracyJudge* judge, const TimingSettings& settings,
                   const TimeBudget& left, Monitor& progress) {
  if (left.none()) return not_run(task.spec, "the time for the whole measurement is used up");
  SolveEstimate estimate(progress);
  RunLimits limits;
  limits.certify = judge == nullptr;
  limits.limits_proofs = false;  // they are not what is measured
  limits.time_limit_s = left.for_one_solve();
  const SolveRun run = solve_once(task, settings, limits, &estimate);
  CellRecord record = record_of(task, run, judge);
  if (run.status != RunStatus::timed_out) return record;
  record.limit_s = limits.time_limit_s;
  set_estimate(estimate, record);
  return record;
}

/// Why a repetition is not the same answer as the warm-up; empty: it is.
std::string changed_answer(const CellRecord& first, const SolveRun& run) {
  if (run.status != first.status)
    return fmt::format("A repetition ended as '{}': {}", word(run.status), run.reason);
  if (run.counts != first.counts || run.work.iterations != first.work.iterations ||
      run.particulars != first.particulars) {
    return "A repetition with the same seed gave another answer.";
  }
  return "";
}

void repeat(Work& work, const TimingSettings& settings, const TimeBudget& left) {
  RunLimits limits;
  limits.checks_counts = false;  // they are those of the warm-up
  limits.time_limit_s = left.for_one_solve();
  ++work.begun;
  const SolveRun run = solve_once(*work.task, settings, limits);
  if (run.status == RunStatus::interrupted || run.status == RunStatus::timed_out) return;
  work.record.difference = changed_answer(work.record, run);
  if (work.record.is_right()) {
    work.record.repetitions.push_back(run.timing);
  } else {
    work.record.repetitions.clear();
  }
}

/// Cells that have no plan yet share the budget equally, cheapest first: what they cannot use goes to the
/// dearer ones. Where a number was asked for, plans are raised to it.
void plan_repetitions(std::vector<Work>& cells, const TimingSettings& settings) {
  std::vector<CellRecord*> open;
  for (Work& work : cells) {
    if (work.task->is_timed && work.record.is_right() && (work.record.planned == 0 || settings.repetitions))
      open.push_back(&work.record);
  }
  const auto is_cheaper = [](const CellRecord* a, const CellRecord* b) {
    return a->warm_up_s < b->warm_up_s;
  };
  std::stable_sort(open.begin(), open.end(), is_cheaper);
  double budget_s = settings.limits.budget_s;
  for (std::size_t i = 0; i < open.size(); ++i) {
    CellRecord& cell = *open[i];
    const double cost_s = std::max(cell.warm_up_s, 1e-9);
    const double affordable = budget_s / static_cast<double>(open.size() - i) / cost_s;
    const double bounded = std::clamp<double>(affordable, fewest_repetitions, most_repetitions);
    cell.planned = std::max(cell.planned, settings.repetitions.value_or(static_cast<int>(bounded)));
    budget_s = std::max(0.0, budget_s - cell.planned * cost_s);
  }
}

/// So many of `planned` repetitions have had their turn after this round, of `rounds`: turns are spread
/// evenly.
int due(int planned, int round, int rounds) {
  return static_cast<int>(static_cast<std::int64_t>(round + 1) * planned / rounds);
}

std::vector<CellRecord> records_of(const std::vector<Work>& cells) {
  std::vector<CellRecord> records;
  records.reserve(cells.size());
  for (const Work& work : cells) records.push_back(work.record);
  return records;
}

/// What an earlier session decided of the cell, or nullptr.
const CellRecord* find_decided(const CellTask& task, const std::vector<CellRecord>& known,
                               const TimeBudget& left) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const CellRecord& cell) {
    return cell.spec == task.spec && is_decided(task, cell, left.cell_s());
  });
  return found == known.end() ? nullptr : &*found;
}

std::vector<Work> warm_up_all(std::span<const CellTask> tasks, const TimingSettings& settings,
                              const std::vector<CellRecord>& known, TimeBudget& left, Monitor& progress,
                              const CellCheckpoint& checkpoint) {
  std::vector<Work> cells;
  for (const CellTask& task : tasks) {
    if (interrupted()) break;
    if (const CellRecord* earlier = find_decided(task, known, left)) {
      cells.push_back({&task, *earlier, static_cast<int>(earlier->repetitions.size())});
      continue;
    }
    if (settings.limits.skips_variants && has_slow_default(task.spec, cells)) {
      cells.push_back(
          {&task, not_run(task.spec, "the strategy's defaults already take too long; --full has no limit")});
      continue;
    }
    CellProgress cell_progress(progress, task.spec, cells.size(), tasks.size());
    const auto before = Clock::now();
    const AccuracyJudge* judge = task.judge ? task.judge(cell_progress) : nullptr;
    if (interrupted()) break;
    left.leave_out(Clock::now() - before);
    cells.push_back({&task, warm_up(task, judge, settings, left, cell_progress)});
    checkpoint(records_of(cells));
  }
  return cells;
}

/// What so many repetitions of the cell take, as far as its first solve tells.
double cost_s(const Work& work, int repetitions) {
  return work.record.is_right() ? repetitions * work.record.warm_up_s : 0;
}

/// What is still to be repeated of all cells.
double cost_left_s(const std::vector<Work>& cells) {
  double cost = 0;
  for (const Work& work : cells) cost += cost_s(work, std::max(0, work.record.planned - work.begun));
  return cost;
}

void repeat_all(std::vector<Work>& cells, const TimingSettings& settings, const TimeBudget& left,
                Monitor& progress, const CellCheckpoint& checkpoint) {
  plan_repetitions(cells, settings);
  int rounds = 0;
  for (const Work& work : cells) rounds = std::max(rounds, work.record.planned);
  auto stored = Clock::now();
  const double all_s = cost_left_s(cells);
  double done_s = 0;
  std::vector<Work*> turns;
  for (Work& work : cells) turns.push_back(&work);
  std::mt19937_64 random(settings.seed);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(turns.begin(), turns.end(), random);
    for (Work* turn : turns) {
      Work& work = *turn;
      if (interrupted() || left.none()) return;
      if (!work.record.is_right() || work.begun >= due(work.record.planned, round, rounds)) continue;
      progress.progress("repetitions", all_s > 0 ? done_s / all_s : -1);
      done_s += cost_s(work, 1);
      repeat(work, settings, left);
      if (Clock::now() - stored < storing_interval) continue;
      checkpoint(records_of(cells));
      stored = Clock::now();
    }
  }
}

/// The records, and what is known of cells that have none yet.
std::vector<CellRecord> with_known(std::vector<CellRecord> records, const std::vector<CellRecord>& known) {
  const std::size_t measured = records.size();
  for (const CellRecord& cell : known) {
    const auto end = records.begin() + static_cast<std::ptrdiff_t>(measured);
    const bool is_there =
        std::any_of(records.begin(), end, [&](const CellRecord& other) { return other.spec == cell.spec; });
    if (!is_there) records.push_back(cell);
  }
  return records;
}

}  // namespace

std::vector<CellRecord> time_cells(std::span<const CellTask> tasks, const TimingSettings& settings,
                                   const std::vector<CellRecord>& known, Monitor& progress,
                                   const CellCheckpoint& checkpoint) {
  TimeBudget left(settings);
  const auto keep = [&](const std::vector<CellRecord>& cells) { checkpoint(with_known(cells, known)); };
  std::vector<Work> cells = warm_up_all(tasks, settings, known, left, progress, keep);
  std::vector<CellRecord> judged = records_of(cells);
  note_differences(judged, settings.expected);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].record = judged[i];
  repeat_all(cells, settings, left, progress, keep);
  return with_known(records_of(cells), known);
}

}  // namespace gcs
