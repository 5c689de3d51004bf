#include "harness/sweeps/step_bound_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "harness/base/stop_conditions.hpp"
#include "harness/results/strategy_choice.hpp"

namespace gcs {
namespace {

constexpr std::array<std::string_view, 2> strategies{"full-space", "rcp"};

/// Two runs hold the same solution when no distance differs by more than this, relative to the largest. Runs
/// refine to full accuracy, so only solutions next to a fold come near it; then the nearest one decides.
constexpr double same_solution = 1e-5;

/// Where a path closes is found to about 1e-6, and each step of an error below 1e-9 adds to the length.
constexpr double same_length = 1e-5;

/// A solution and the direction in which t = 1 was crossed there.
struct Meeting {
  int solution = 0;
  int direction = 1;
  bool operator==(const Meeting&) const = default;
};
using Meetings = std::vector<Meeting>;

/// Numbers the classes of several runs in common.
class SolutionNumbers {
 public:
  /// The meetings of a run in the order in which the path has them.
  Meetings meetings(const Assessment& assessment) {
    const bool first = distances_.empty();
    std::vector<int> numbers;
    for (const AssessedSolution& solution : assessment.solutions)
      numbers.push_back(number(distances(solution.figure), first));
    Meetings result;
    for (const AssessedCrossing& crossing : assessment.crossings)
      if (crossing.solution) result.push_back({numbers[*crossing.solution], crossing.direction});
    return result;
  }

 private:
  static Eigen::VectorXd distances(const Figure& figure) {
    const Eigen::Index n = figure.points.cols();
    Eigen::VectorXd result(n * (n - 1) / 2);
    Eigen::Index next = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < i; ++j)
        result[next++] = (figure.points.col(i) - figure.points.col(j)).norm();
    return result;
  }

  int number(const Eigen::VectorXd& distances, bool is_new) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    for (std::size_t i = 0; i < distances_.size() && !is_new; ++i) {
      const double difference = (distances_[i] - distances).cwiseAbs().maxCoeff();
      if (difference < nearest) found = i;
      nearest = std::min(nearest, difference);
    }
    if (nearest <= same_solution * distances.maxCoeff()) return static_cast<int>(found);
    distances_.push_back(distances);
    return static_cast<int>(distances_.size()) - 1;
  }

  std::vector<Eigen::VectorXd> distances_;
};

Meetings reversed(Meetings meetings) {
  std::reverse(meetings.begin(), meetings.end());
  for (Meeting& meeting : meetings) meeting.direction *= -1;
  return meetings;
}

/// The shortest sequence of which the given one is a repetition.
Meetings one_round(const Meetings& meetings) {
  const std::size_t size = meetings.size();
  for (std::size_t period = 1; 2 * period <= size; ++period) {
    if (size % period != 0) continue;
    const auto tail = meetings.begin() + static_cast<std::ptrdiff_t>(period);
    if (std::equal(tail, meetings.end(), meetings.begin())) return {meetings.begin(), tail};
  }
  return meetings;
}

bool same_circle(const Meetings& a, const Meetings& b) {
  if (a.size() != b.size()) return false;
  if (a.empty()) return true;
  Meetings twice = a;
  twice.insert(twice.end(), a.begin(), a.end());
  return std::search(twice.begin(), twice.end(), b.begin(), b.end()) != twice.end();
}

bool same_undirected_circle(const Meetings& a, const Meetings& b) {
  const Meetings first = one_round(a);
  const Meetings second = one_round(b);
  return same_circle(first, second) || same_circle(first, reversed(second));
}

std::size_t lacking(const Meetings& all, const Meetings& some) {
  std::set<int> missed;
  for (const Meeting& meeting : all) missed.insert(meeting.solution);
  for (const Meeting& meeting : some) missed.erase(meeting.solution);
  return missed.size();
}

std::string label(const BoundedRun& run) { return run.strategy + " (" + run.bound + ")"; }

std::string difference(const BoundedRun& run, const Meetings& found, const BoundedRun& other,
                       const Meetings& expected) {
  const std::size_t missing = lacking(expected, found);
  const std::size_t more = lacking(found, expected);
  const std::string what =
      missing == 0 && more == 0
          ? "the same solutions in another order"
          : fmt::format("{} solutions missing and {} that the other lacks", missing, more);
  return fmt::format("{} differs from {}: {} crossings instead of {}, {}", label(run), label(other),
                     found.size(), expected.size(), what);
}

/// Compares each complete run with the first complete one of its strategy, and that with the first of all.
class Comparison {
 public:
  explicit Comparison(StepBoundVerdict& verdict) : verdict_(verdict) {}

  void run() {
    for (const BoundedRun& run : verdict_.runs) {
      for (const FailedCheck& check : run.assessment.failed_checks)
        verdict_.differences.push_back(label(run) + ": " + check.what);
      if (run.complete())
        compare(run);
      else
        verdict_.unfinished.push_back(label(run) + ": " + run.report.reason);
    }
  }

 private:
  using Judged = std::pair<const BoundedRun*, Meetings>;

  void compare(const BoundedRun& run) {
    const Meetings found = numbers_.meetings(run.assessment);
    const auto same_strategy = [&](const Judged& first) { return first.first->strategy == run.strategy; };
    const auto own = std::find_if(firsts_.begin(), firsts_.end(), same_strategy);
    if (own != firsts_.end()) {
      if (found != own->second)
        differs(run, found, *own);
      else
        compare_lengths(run, *own->first);
      return;
    }
    if (firsts_.empty())
      verdict_.solutions = run.assessment.solutions.size();
    else if (!same_undirected_circle(firsts_.front().second, found))
      differs(run, found, firsts_.front());
    firsts_.emplace_back(&run, found);
  }

  void compare_lengths(const BoundedRun& run, const BoundedRun& other) {
    if (std::abs(run.length() - other.length()) <= same_length * (1 + other.length())) return;
    verdict_.differences.push_back(fmt::format("{} differs from {}: a path of length {} instead of {}",
                                               label(run), label(other), run.length(), other.length()));
  }

  void differs(const BoundedRun& run, const Meetings& found, const Judged& other) {
    verdict_.differences.push_back(difference(run, found, *other.first, other.second));
  }

  StepBoundVerdict& verdict_;
  SolutionNumbers numbers_;
  std::vector<Judged> firsts_;  // of each strategy
};

SolveReport report_of(Strategy& strategy, const Scene& scene, std::optional<double> time_limit_s) {
  const StopWatch watch(time_limit_s);
  const SolveRequest request(scene, {.stop = watch.token()});
  SolveReport report;
  if (const auto why_not = strategy.why_unsupported(request)) {
    report.reason = *why_not;
    return report;
  }
  strategy.prepare(request);
  return strategy.solve(request);
}

BoundedRun run_at(std::string_view strategy, const StepBound& bound, const Scene& scene,
                  std::optional<double> time_limit_s) {
  const StrategyEntry& entry = find_strategy(strategy);
  BoundedRun run{std::string(strategy), bound.name, complete_options(entry, bound.options), {}, {}};
  run.report = report_of(*entry.make(run.options), scene, time_limit_s);
  run.assessment = assess(scene, run.report);
  return run;
}

}  // namespace

std::vector<StepBound> default_step_bounds() {
  return {
      {"default", {}}, {"step_max 1/4", {{"step_max", "0.25"}}}, {"step_max 1/16", {{"step_max", "0.0625"}}}};
}

std::string StepBoundVerdict::explanation() const {
  std::vector<std::string> lines = unfinished;
  lines.insert(lines.end(), differences.begin(), differences.end());
  return fmt::format("{}", fmt::join(lines, "\n"));
}

StepBoundVerdict check_step_bounds(const Scene& scene, std::span<const StepBound> bounds,
                                   std::optional<double> time_limit_s) {
  StepBoundVerdict verdict;
  for (const std::string_view strategy : strategies)
    for (const StepBound& bound : bounds)
      verdict.runs.push_back(run_at(strategy, bound, scene, time_limit_s));
  Comparison(verdict).run();
  return verdict;
}

}  // namespace gcs
