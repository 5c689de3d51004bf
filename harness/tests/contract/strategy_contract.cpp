#include "harness/tests/contract/strategy_contract.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "harness/solving/solve_run.hpp"
#include "harness/tests/contract/count_limits.hpp"
#include "harness/tests/contract/distance_of_figures.hpp"
#include "harness/tests/contract/known_counts.hpp"
#include "harness/tests/contract/report_agreement.hpp"
#include "harness/tests/contract/report_difference.hpp"
#include "solvers/answers/assess.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/numeric/rounding.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs::contract {
namespace {

/// Relative to the lengths. Rounding the coordinates of a figure that is as large as its lengths leaves about
/// 1e-15.
constexpr double residual_limit = 1e-13;

/// Relative to the scene's size: the same point computed twice differs by less, two points of one class in
/// the instances tested by more.
constexpr double same_point = 1e-9;

/// Collects violations of one check.
class Finder {
 public:
  template <class... Values>
  void expect(bool holds, std::string_view check, fmt::format_string<Values...> what, Values&&... values) {
    if (!holds) found_.push_back({std::string(check), fmt::format(what, std::forward<Values>(values)...)});
  }

  void append(const Violations& others) { found_.insert(found_.end(), others.begin(), others.end()); }
  Violations take() { return std::move(found_); }

 private:
  Violations found_;
};

/// True for what a person can read as a reason.
bool is_sentence(const std::string& text) {
  return std::count(text.begin(), text.end(), ' ') >= 2 && text.find('\n') == std::string::npos;
}

bool is_decided(PathRecord::End end) {
  return end != PathRecord::End::failed && end != PathRecord::End::stopped;
}

void check_status(const SolveReport& report, Finder& finder) {
  const bool complete = report.status == SolveStatus::complete;
  finder.expect(complete || is_sentence(report.reason), "status", "status {} without a reason",
                static_cast<int>(report.status));
  finder.expect(!complete || report.reason.empty(), "status", "complete with a reason: {}", report.reason);
  finder.expect(report.claim != Claim::on_path || report.paths.size() == 1, "status",
                "{} paths in a report on the path S", report.paths.size());
  for (std::size_t i = 0; i < report.paths.size(); ++i) {
    const PathRecord& path = report.paths[i];
    const bool decided = is_decided(path.end);
    finder.expect(decided || is_sentence(path.cause), "status", "path {} has no end and no cause", i);
    finder.expect(decided || !complete, "status", "complete although path {} has no end", i);
    finder.expect(!complete || report.claim != Claim::on_path || path.end == PathRecord::End::closed,
                  "status", "all solutions on S although path {} did not close", i);
  }
}

bool is_well_formed(const Scene& scene, const Candidate& candidate) {
  const Figure& figure = candidate.figure;
  const auto finite = [](const ComplexLine& line) {
    return line.point.allFinite() && line.direction.allFinite();
  };
  if (figure.imaginary_lines.size() > figure.lines.size()) return false;
  const std::vector<ComplexLine> lines = complex_lines(figure);
  return figure.points.cols() == scene.point_count() && lines.size() == scene.problem().lines.size() &&
         figure.points.allFinite() && std::all_of(lines.begin(), lines.end(), finite) &&
         (scene.dimension() == 3 || figure.points.row(2).isZero(0)) && candidate.multiplicity >= 1;
}

bool is_well_formed(const WorkCounters& work) {
  const auto counts = {work.iterations,     work.rejected_steps,      work.newton_iterations,
                       work.evaluations,    work.partial_evaluations, work.jacobians,
                       work.factorisations, work.plan_changes};
  return std::all_of(counts.begin(), counts.end(), [](std::int64_t count) { return count >= 0; }) &&
         work.smallest_step.value_or(1) > 0 && work.mean_driving_parameters.value_or(0) >= 0 &&
         work.mean_driving_parameters.value_or(0) <= work.max_driving_parameters.value_or(0);
}

/// Names are words for a file's field, each once.
bool is_well_formed(const std::vector<Particular>& particulars) {
  std::set<std::string> names;
  return std::all_of(particulars.begin(), particulars.end(), [&](const Particular& particular) {
    const auto is_allowed = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
    return std::all_of(particular.name.begin(), particular.name.end(), is_allowed) &&
           !particular.name.empty() && names.insert(particular.name).second && particular.value >= 0;
  });
}

void check_path_form(const PathRecord& path, int candidates, Finder& finder) {
  finder.expect(std::isfinite(path.length) && path.length >= 0, "malformed", "a path has the length {}",
                path.length);
  for (const Crossing& crossing : path.crossings)
    finder.expect(
        crossing.candidate >= 0 && crossing.candidate < candidates && std::abs(crossing.direction) == 1,
        "malformed", "a crossing names candidate {} with direction {}", crossing.candidate,
        crossing.direction);
}

void check_form(const Scene& scene, const SolveReport& report, Finder& finder) {
  const int candidates = static_cast<int>(report.candidates.size());
  for (int i = 0; i < candidates; ++i)
    finder.expect(is_well_formed(scene, report.candidates[i]), "malformed",
                  "candidate {} lacks an entity, is not finite, not plane or has no multiplicity", i);
  for (const PathRecord& path : report.paths) check_path_form(path, candidates, finder);
  const auto values = std::ssize(scene.problem().constraints) + std::ssize(scene.problem().relations);
  for (const CurveRecord& curve : report.curves) {
    check_path_form(curve.path, candidates, finder);
    finder.expect(curve.released >= 0 && curve.released < values, "malformed", "a curve lacks value {}",
                  curve.released);
  }
  finder.expect(is_well_formed(report.work), "malformed", "a counter is negative or contradicts another");
  finder.expect(is_well_formed(report.particulars), "malformed",
                "a particular is negative, has another name than a word or the name of another");
}

/// A distance between complex points is a difference of squares as large as the figure, over the length.
double rounding_growth(const Scene& scene, const Figure& figure) {
  if (figure.is_real()) return 1;
  const auto& lengths = scene.target_lengths();
  const double stretch = extent(figure) / *std::min_element(lengths.begin(), lengths.end());
  return std::max(1.0, stretch * stretch);
}

void check_residuals(const Scene& scene, const SolveReport& report, Finder& finder) {
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    const Figure& figure = report.candidates[i].figure;
    const double residual = relative_residual(scene, figure);
    finder.expect(residual <= residual_limit * rounding_growth(scene, figure), "residual",
                  "candidate {} has a residual of {:.2g}", i, residual);
  }
}

/// A stated one has as many digits as rounding leaves.
void check_conditions(const Scene& scene, const SolveReport& report, Finder& finder) {
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    const Candidate& candidate = report.candidates[i];
    if (!candidate.condition) continue;
    const double condition = jacobian_condition(scene, candidate.figure);
    const double digits = 64 * unit_roundoff * condition;
    finder.expect(
        *candidate.condition == condition || std::abs(*candidate.condition / condition - 1) <= digits,
        "condition", "candidate {} has a condition number of {:.3g}, not {:.3g}", i, condition,
        *candidate.condition);
  }
}

void check_duplicates(const Scene& scene, const SolveReport& report, Finder& finder) {
  std::vector<Figure> figures;
  for (const Candidate& candidate : report.candidates) figures.push_back(scene.in_frame(candidate.figure));
  for (std::size_t i = 0; i < figures.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      finder.expect(distance_of(figures[i], figures[j]) > same_point * scene.size(), "duplicate",
                    "candidates {} and {} are the same point", j, i);
}

void check_alternation(const PathRecord& path, Finder& finder) {
  const std::size_t count = path.crossings.size();
  const std::size_t pairs = path.end == PathRecord::End::closed || count == 0 ? count : count - 1;
  for (std::size_t i = 0; i < pairs; ++i)
    finder.expect(path.crossings[i].direction != path.crossings[(i + 1) % count].direction, "alternation",
                  "crossings {} and {} have the same direction", i, (i + 1) % count);
}

/// Counts calls, and asks for a stop at the first if it has a source.
class Watcher final : public Monitor {
 public:
  explicit Watcher(std::stop_source* source = nullptr) : source_(source) {}
  void progress(std::string_view, double) override {
    ++calls_;
    if (source_) source_->request_stop();
  }
  int calls() const { return calls_; }

 private:
  std::stop_source* source_;
  int calls_ = 0;
};

void check_stopped(const Scene& scene, const SolveReport& stopped, const SolveReport& whole, Finder& finder) {
  finder.expect(stopped.status == SolveStatus::stopped, "stop", "asked to stop, the status is {}",
                static_cast<int>(stopped.status));
  for (const Violation& violation : check_report(scene, stopped))
    finder.expect(false, "stop", "the report of a stopped solve: {}", violation.what);
  if (const auto found = outsider(scene, stopped, whole))
    finder.expect(false, "stop", "stopped, against the whole: {}", *found);
}

/// The subject in another unit: options that are lengths are the same lengths.
Subject in_unit(const Subject& subject, int exponent) {
  Subject result = subject;
  const OptionMap options = complete_options(subject.entry, subject.given);
  for (const OptionSpec& option : subject.entry.options)
    if (const std::string& length = options.find(option.name)->second; option.is_length && length != "auto")
      result.given[std::string(option.name)] = times_power_of_two(length, exponent);
  return result;
}

}  // namespace

std::string in_words(const Violations& violations) {
  std::string words;
  for (const Violation& violation : violations) words += violation.check + ": " + violation.what + "\n";
  return words;
}

std::string Subject::label() const {
  std::string label(entry.name);
  for (const auto& [name, value] : given) label += fmt::format(" {}={}", name, value);
  return label;
}

/// A plan with two angles is subdivided in the plane of both, which takes long; plan_scan_test.cpp has
/// one that does not. So do proofs of all curves between many solutions.
bool takes_too_long(const Subject& subject, const Scene& scene) {
  const std::string_view name = subject.entry.name;
  const bool proves_curves = name == "explore" && subject.given.contains("mode");
  return (name == "plan-scan" && !scene.problem().is_general() && derive_scan_plan(scene).angles() > 1) ||
         ((name == "monodromy" || name == "polyhedral" || proves_curves) && has_many_solutions(scene));
}

bool supports(const Subject& subject, const Scene& scene) {
  return !why_not(subject.entry, *subject.make(), scene) && !takes_too_long(subject, scene);
}

std::int64_t effort(const WorkCounters& work) {
  return work.iterations + work.rejected_steps + work.newton_iterations + work.evaluations +
         work.partial_evaluations + work.jacobians + work.factorisations;
}

SolveReport solve_anew(const Subject& subject, const SolveRequest& request) {
  const auto strategy = subject.make();
  strategy->prepare(request);
  return strategy->solve(request);
}

Violations check_refusal(const Subject& subject, const Scene& scene) {
  Finder finder;
  const auto reason = why_not(subject.entry, *subject.make(), scene);
  finder.expect(!reason || is_sentence(*reason), "support", "refused in so many words: '{}'",
                reason.value_or(""));
  return finder.take();
}

Violations check_completion(const SolveReport& report, bool has_simple_solutions) {
  Finder finder;
  // Newton's method alone finds no multiple solution, and says so.
  if (!has_simple_solutions && report.claim == Claim::some_real && report.candidates.empty())
    return finder.take();
  const bool leaves_multiple = report.status == SolveStatus::partial && report.claim == Claim::all_real &&
                               std::any_of(report.candidates.begin(), report.candidates.end(),
                                           [](const Candidate& found) { return found.multiplicity > 1; });
  finder.expect(report.status == SolveStatus::complete || leaves_multiple, "support",
                "supported, but not solved: {}", report.reason);
  return finder.take();
}

Violations check_report(const Scene& scene, const SolveReport& report) {
  Finder finder;
  check_form(scene, report, finder);
  check_status(report, finder);
  Violations found = finder.take();
  if (std::any_of(found.begin(), found.end(), [](const Violation& v) { return v.check == "malformed"; }))
    return found;
  finder.append(found);
  check_residuals(scene, report, finder);
  check_conditions(scene, report, finder);
  check_duplicates(scene, report, finder);
  for (const PathRecord& path : report.paths) check_alternation(path, finder);
  for (const FailedCheck& failed : assess(scene, report).failed_checks)
    finder.expect(false, "assessed", "{}: {}", failed.name, failed.what);
  return finder.take();
}

Violations check_counts(std::string_view instance, const Scene& scene, const SolveReport& report) {
  Finder finder;
  const auto known = known_counts(instance);
  if (!known) return {};
  const Assessment assessment = assess(scene, report);
  const auto expect = [&](const std::optional<Natural>& found, const std::optional<Natural>& exact,
                          std::string_view which, bool is_bound) {
    if (!found || !exact) return;
    finder.expect(is_bound ? *found <= *exact : *found == *exact, "count", "{} {}, {} {}", found->decimal(),
                  which, is_bound ? "at most" : "exactly", exact->decimal());
  };
  const bool partial = report.status != SolveStatus::complete;
  const Counts& counts = assessment.counts;
  const std::optional<std::uint64_t> real = known->real;
  const std::optional<std::uint64_t> listed =
      std::count_if(assessment.solutions.begin(), assessment.solutions.end(),
                    [](const auto& s) { return s.figure.is_real(); });
  expect(listed, real, "real classes", true);
  expect(counts.real_up_to_reflection, real, "real classes", partial);
  expect(counts.complex_up_to_reflection, known->complex, "complex classes", partial);
  if (report.claim == Claim::on_path) expect(counts.on_path, known->on_path, "classes on S", partial);
  return finder.take();
}

Violations check_repeatability(const Subject& subject, const Scene& scene, const Scene& other) {
  Finder finder;
  const auto strategy = subject.make();
  const SolveRequest request(scene);
  strategy->prepare(request);
  const SolveReport first = strategy->solve(request);
  const auto compare = [&](std::string_view which, const SolveReport& report) {
    const auto difference = first_difference(first, report);
    finder.expect(!difference, "repeatable", "{} reports another {}", which, difference.value_or(""));
  };
  compare("the same object", strategy->solve(request));
  compare("another object", solve_anew(subject, request));
  Watcher watcher;
  compare("a watched one", solve_anew(subject, {scene, {.monitor = &watcher}}));
  compare("one with two threads", solve_anew(subject, {scene, {.threads = 2}}));
  if (supports(subject, other)) {
    strategy->prepare(other);
    strategy->solve(other);
    strategy->prepare(request);
    compare("one that solved another scene before", strategy->solve(request));
  }
  return finder.take();
}

Violations check_reuse(const Subject& subject, const Scene& prepared, const Scene& scene) {
  Finder finder;
  const auto strategy = subject.make();
  strategy->prepare(prepared);
  const SolveReport reused = strategy->solve(scene);
  const SolveReport anew = solve_anew(subject, scene);
  finder.expect(reused.status == anew.status, "reuse", "prepared with other lengths, the status is {}: {}",
                static_cast<int>(reused.status), reused.reason);
  for (const Violation& violation : check_report(scene, reused))
    finder.expect(false, "reuse", "prepared with other lengths: {}", violation.what);
  if (const auto found = contradiction(scene, anew, reused)) finder.expect(false, "reuse", "{}", *found);
  return finder.take();
}

Violations check_stop(const Subject& subject, const Scene& scene, const SolveReport& whole) {
  Finder finder;
  std::stop_source at_once;
  at_once.request_stop();
  const SolveReport stopped = solve_anew(subject, {scene, {.stop = at_once.get_token()}});
  check_stopped(scene, stopped, whole, finder);
  finder.expect(effort(stopped.work) <= effort(whole.work) / 4, "stop",
                "told not to begin, it does {} of {} units of work", effort(stopped.work),
                effort(whole.work));

  std::stop_source on_the_way;
  Watcher watcher(&on_the_way);
  const SolveReport halted =
      solve_anew(subject, {scene, {.stop = on_the_way.get_token(), .monitor = &watcher}});
  if (watcher.calls() > 0) check_stopped(scene, halted, whole, finder);
  return finder.take();
}

namespace {

/// `report`: on the original scene; empty where the subject does not support it.
Violations check_restatement(const Subject& subject, const Scene& scene,
                             const std::optional<SolveReport>& report, const Restatement& restatement) {
  Finder finder;
  const Scene restated(restatement.problem);
  const Subject other_subject = in_unit(subject, restatement.unit_exponent);
  const bool is_supported = supports(other_subject, restated);
  finder.expect(is_supported == report.has_value(), restatement.name, "support depends on it");
  if (!is_supported || !report) return finder.take();
  SolveReport other = solve_anew(other_subject, restated);
  if (restatement.is_exact) {
    const auto difference = first_difference(*report, other);
    finder.expect(!difference, restatement.name, "reports another {}", difference.value_or(""));
  }
  for (Candidate& candidate : other.candidates) candidate.figure = restatement.original(candidate.figure);
  finder.expect(report->status == other.status, restatement.name, "the status is {}, was {}",
                static_cast<int>(other.status), static_cast<int>(report->status));
  if (const auto found = contradiction(scene, *report, other))
    finder.expect(false, restatement.name, "{}", *found);
  return finder.take();
}

}  // namespace

std::vector<Restatement> restatements(const ProblemStatement& problem, std::mt19937_64& random) {
  std::vector<Restatement> all{relabelled(problem, random), constraints_permuted(problem, random),
                               mirrored(problem), ends_swapped(problem)};
  for (const int exponent : {40, -40, -3, 5}) all.push_back(scaled(problem, exponent));
  return all;
}

Violations check_restatements(const Subject& subject, const ProblemStatement& problem,
                              const std::vector<Restatement>& restatements) {
  Finder finder;
  const Scene scene(problem);
  std::optional<SolveReport> report;
  if (supports(subject, scene)) report = solve_anew(subject, scene);
  for (const Restatement& restatement : restatements)
    finder.append(check_restatement(subject, scene, report, restatement));
  return finder.take();
}

}  // namespace gcs::contract
