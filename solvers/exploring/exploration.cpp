#include "solvers/exploring/exploration.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>

#include "solvers/exploring/random_starts.hpp"
#include "solvers/exploring/report_block.hpp"
#include "solvers/exploring/unseen_classes.hpp"
#include "solvers/running/run_on_threads.hpp"
#include "solvers/running/words.hpp"
#include "solvers/tracking/scene_path.hpp"

namespace gcs {
namespace {

std::vector<Eigen::Index> equations_with_value(const ExploredScene& explored) {
  std::vector<Eigen::Index> equations;
  for (std::size_t e = 0; e < explored.value_of().size(); ++e)
    if (explored.value_of()[e] >= 0) equations.push_back(static_cast<Eigen::Index>(e));
  return equations;
}

}  // namespace

Exploration::Exploration(const SolveRequest& request, const WalkOptions& walks,
                         const ExplorationLimits& limits)
    : request_(request),
      walks_(walks),
      limits_(limits),
      context_{request.stop, nullptr},
      explored_(explored_scene(request.scene)),
      releasable_(equations_with_value(*explored_)),
      yield_(releasable_.size(), std::numeric_limits<double>::infinity()),
      graph_(request.scene, releasable_.size()) {}

SolveReport Exploration::run() {
  find_first();
  do walk_all();
  while (may_go_on() && start_anew());
  return report();
}

/// By S, or by Newton's method from the sketch; random starts are what is left to try then.
void Exploration::find_first() {
  if (!request_.scene.sketch()) return;
  take(
      recalled_or({}, [&] {
        return Reports{follow_scene_path(request_.scene, walks_.tracking, {request_.stop, request_.monitor})};
      }).front());
  if (graph_.size() > 0 || request_.stop.stop_requested()) return;
  constexpr double settled = 1e-10;
  Eigen::VectorXd x = explored_->unknowns(*request_.scene.sketch());
  const Refinement refinement = refine(explored_->equations(), settled, x);
  work_.newton_iterations += refinement.iterations;
  if (refinement.converged) graph_.take({{explored_->target().figure(x)}});
}

void Exploration::take(const SolveReport& found) {
  add(found.work, work_);
  graph_.take(found.candidates);
}

bool Exploration::may_go_on() const {
  const auto unseen = unseen_classes(graph_.meetings(), graph_.size());
  return !request_.stop.stop_requested() && std::ssize(graph_.curves()) < limits_.most_curves &&
         !(unseen && *unseen < limits_.unseen);
}

void Exploration::walk_all() {
  while (may_go_on()) {
    if (request_.monitor != nullptr) request_.monitor->progress("walking curves", graph_.walked_part());
    const std::vector<Walk> round = next_round();
    if (round.empty()) return;
    walk(round);
  }
}

/// Small, so that each choice knows what the last ones led to, and growing with what is there to do, for many threads.
std::size_t Exploration::round_size() const {
  constexpr int least = 8, solutions_for_curve = 8;
  const std::int64_t left = limits_.most_curves - std::ssize(graph_.curves());
  return static_cast<std::size_t>(
      std::min<std::int64_t>(left, std::max(least, graph_.size() / solutions_for_curve)));
}

/// Of the values that are not taken and not walked from this solution; the first of equal ones.
std::optional<std::size_t> Exploration::best_value(int start, const std::vector<bool>& is_taken) const {
  std::optional<std::size_t> best;
  for (std::size_t value = 0; value < releasable_.size(); ++value)
    if (!is_taken[value] && !graph_.is_walked(start, value) && (!best || yield_[value] > yield_[*best]))
      best = value;
  return best;
}

std::vector<Exploration::Walk> Exploration::next_round() const {
  using Open = std::pair<std::size_t, int>;  // curves walked, number of the solution
  std::vector<Open> open;
  for (int start = 0; start < graph_.size(); ++start)
    if (graph_.walked(start) < releasable_.size()) open.emplace_back(graph_.walked(start), start);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> least_walked(std::greater<>{},
                                                                            std::move(open));
  std::vector<Walk> round;
  std::vector<bool> is_taken(releasable_.size(), false);
  while (round.size() < round_size() && !least_walked.empty()) {
    const auto [walked, start] = least_walked.top();
    least_walked.pop();
    const std::optional<std::size_t> value = best_value(start, is_taken);
    if (!value) continue;
    is_taken[*value] = true;
    round.push_back({*value, start});
    least_walked.emplace(walked + 1, start);
  }
  return round;
}

void Exploration::walk(const std::vector<Walk>& round) {
  std::vector<Eigen::VectorXd> starts;
  Digest digest;
  for (const Walk& one : round) {
    starts.push_back(explored_->unknowns(graph_.solutions()[static_cast<std::size_t>(one.start)].figure));
    digest.add(one.value);
    digest.add(std::span(starts.back().data(), static_cast<std::size_t>(starts.back().size())));
  }
  take(round, recalled_or(digest, [&] {
         Reports reports(round.size());
         share_on_threads(round.size(), request_.threads, [&](std::size_t i) {
           reports[i] = walk_curve(request_.scene, *explored_, releasable_[round[i].value], starts[i], walks_,
                                   context_);
         });
         return reports;
       }));
}

/// What the journal has of the next step, or what it gives now.
Exploration::Reports Exploration::recalled_or(const Digest& step, const std::function<Reports()>& compute) {
  if (request_.journal == nullptr) return compute();
  Reports reports;
  const auto block = request_.journal->result(step.value(), [&]() -> std::optional<Journal::Block> {
    reports = compute();
    if (request_.stop.stop_requested()) return std::nullopt;
    return to_block(reports);
  });
  return block ? reports_from(*block) : reports;
}

void Exploration::take(const std::vector<Walk>& round, Reports reports) {
  int known = graph_.size();
  std::vector<Candidate> found;
  for (const SolveReport& report : reports)
    found.insert(found.end(), report.candidates.begin(), report.candidates.end());
  const std::vector<int> numbers = graph_.take(found);
  auto first = numbers.begin();
  for (std::size_t i = 0; i < round.size(); ++i) {
    SolveReport& report = reports[i];
    const auto last = first + std::ssize(report.candidates);
    add(report.work, work_);
    if (report.status == SolveStatus::partial && first_doubt_.empty()) first_doubt_ = report.reason;
    if (std::any_of(first, last, [](int number) { return number < 0; }) && first_doubt_.empty())
      first_doubt_ = "a point at which the value fits is singular, or nearly so";
    const int released = explored_->value_of()[static_cast<std::size_t>(releasable_[round[i].value])];
    CurveRecord curve = report.curves.empty() ? CurveRecord() : std::move(report.curves.front());
    curve.released = released;
    curve.path = std::move(report.paths.front());
    graph_.add_curve(round[i].value, round[i].start, std::move(curve), {first, last});
    const int reached = first == last ? known : std::max(known, *std::max_element(first, last) + 1);
    learn(round[i].value, reached - known);
    known = reached;
    first = last;
  }
}

/// The mean of all curves would not follow that fewer and fewer lead to new ones.
void Exploration::learn(std::size_t value, int new_solutions) {
  constexpr double newest_part = 0.2;
  double& mean = yield_[value];
  mean = std::isinf(mean) ? new_solutions : mean + newest_part * (new_solutions - mean);
}

/// Whether a random start leads to a solution that no curve has met.
bool Exploration::start_anew() {
  if (request_.monitor != nullptr) request_.monitor->progress("random starts", graph_.walked_part());
  const int known = graph_.size();
  Digest digest;
  digest.add(static_cast<std::uint64_t>(started_));
  const SolveReport ends = recalled_or(digest, [&] { return Reports{report_on_starts()}; }).front();
  started_ += limits_.starts;
  singular_starts_ += static_cast<int>(ends.particulars.front().value);
  take(ends);
  return graph_.size() > known;
}

SolveReport Exploration::report_on_starts() const {
  SolveReport report;
  report.particulars = {{"singular", 0}};
  ProvenNeighbours neighbours(request_.scene);
  for (StartEnd& end : ends_of_starts(request_, started_, started_ + limits_.starts, neighbours)) {
    add(end.work, report.work);
    report.particulars.front().value += end.is_singular ? 1 : 0;
    if (end.is_solution) report.candidates.push_back({std::move(end.figure), 1, end.accuracy.error});
  }
  return report;
}

std::string Exploration::shortcomings() const {
  const auto failed = std::ranges::find_if(
      graph_.curves(), [](const CurveRecord& curve) { return curve.path.end == PathRecord::End::failed; });
  if (failed != graph_.curves().end())
    return "a curve could not be followed to its ends: " + failed->path.cause;
  if (!first_doubt_.empty()) return "on a curve " + first_doubt_;
  if (std::ssize(graph_.curves()) >= limits_.most_curves)
    return counted(limits_.most_curves, "curve") + " were walked, and others are left";
  return "";
}

/// Whether every curve from every solution is walked and proven, and all that they meet are among the solutions: no other real
/// solution is joined to one of these by a chain of such curves.
bool Exploration::has_proven_components() const {
  return graph_.size() > 0 && graph_.walked_part() == 1 && first_doubt_.empty() &&
         std::ranges::all_of(graph_.curves(), [](const CurveRecord& curve) { return curve.path.proven; });
}

SolveReport Exploration::report() const {
  SolveReport report;
  report.claim = has_proven_components() ? Claim::all_real_of_component : Claim::some_real;
  report.candidates = graph_.solutions();
  report.curves = graph_.curves();
  report.work = work_;
  report.particulars = {
      {"curves", std::ssize(graph_.curves())},
      {"proven_curves",
       std::ranges::count_if(graph_.curves(), [](const CurveRecord& curve) { return curve.path.proven; })},
      {"meetings", graph_.meetings()},
      {"starts", started_},
      {"singular_points", graph_.singular() + singular_starts_}};
  if (const auto unseen = unseen_classes(graph_.meetings(), graph_.size()))
    report.particulars.push_back({"estimated_unseen_classes", std::llround(*unseen)});
  if (request_.stop.stop_requested()) {
    report.status = SolveStatus::stopped;
    report.reason = "stopped on request";
  } else if (report.candidates.empty()) {
    report.status = SolveStatus::gave_up;
    report.reason = "neither the sketch nor one of " + std::to_string(started_) +
                    " random starts leads to a solution that is not singular";
  } else {
    report.reason = shortcomings();
    report.status = report.reason.empty() ? SolveStatus::complete : SolveStatus::partial;
  }
  return report;
}

}  // namespace gcs
