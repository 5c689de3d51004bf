#include "harness/cli/solve_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <string_view>

#include "harness/base/summary_line.hpp"
#include "harness/cli/certificates_view.hpp"
#include "harness/cli/standing_view.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/solving/counts_view.hpp"
#include "solvers/running/words.hpp"

namespace gcs {

namespace {

/// A longer table scrolls away; the file has it all.
constexpr std::size_t shown_crossings = 40;

/// "1 class", "2 classes"
std::string amount(const Natural& count, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", readable(count), count == Natural(1) ? singular : plural);
}

std::string headline(const Instance& instance, const SolveRun& run) {
  std::string text = fmt::format("{}, {}: {}", instance.id, run.strategy, word(run.status));
  return text + (run.reason.empty() ? "\n" : fmt::format(" ({})\n", run.reason));
}

/// The convention of a count of classes. Where positions are fixed there is no reflection to divide out.
std::string_view convention(const ProblemStatement& problem) {
  return problem.is_anchored() ? "positions are fixed, no reflection is divided out"
                               : word(convention_of(problem));
}

std::string solution_counts(const ProblemStatement& problem, const Counts& counts,
                            const std::optional<Claim>& claim) {
  std::string text;
  const auto append = [&](std::string_view label, const std::optional<Natural>& count,
                          std::string_view what) {
    if (count)
      text += summary_line(label, fmt::format("{}, {}", amount(*count, "solution", "solutions"), what));
  };
  const bool of_core = claim == Claim::on_path_of_core;
  append("on path", counts.on_path,
         fmt::format("met on {}, {}", of_core ? "the core's S, hung points as in the sketch" : "S",
                     convention(problem)));
  append("real", counts.real_up_to_reflection, convention(problem));
  append("complex", counts.complex_up_to_reflection,
         fmt::format("real ones included, {}", convention(problem)));
  if (counts.singular.value_or(0) > 0)
    append("singular", counts.singular, "multiple or too ill-conditioned to tell");
  return text;
}

/// What is listed, where no count says how many there are.
std::string solutions_found(const ProblemStatement& problem, const Assessment& assessment,
                            const std::optional<Claim>& claim) {
  const Counts& counts = assessment.counts;
  if (counts.on_path || counts.real_up_to_reflection || counts.complex_up_to_reflection) return "";
  if (assessment.solutions.empty()) return "";
  const std::size_t all = assessment.solutions.size();
  const auto real = static_cast<std::size_t>(
      std::count_if(assessment.solutions.begin(), assessment.solutions.end(),
                    [](const AssessedSolution& solution) { return solution.is_as_stated(); }));
  const std::string found =
      real == all ? amount(all, "real solution", "real solutions")
                  : fmt::format("{}, {} of them real", amount(all, "solution", "solutions"), real);
  const std::string_view others = claim == Claim::all_real_of_component
                                      ? "proven: no other is joined to them by curves with one value released"
                                      : "there may be more";
  return summary_line("found", fmt::format("{}, {}; {}", found, convention(problem), others));
}

/// Whose claim the counts rest on, where it is not one of ours.
std::string foreign_claim(const SolveRun& run) {
  if (!exec_command(run.strategy) || !run.claim) return "";
  return summary_line("claim", fmt::format("{}, as the program claims", word(*run.claim)));
}

std::string path_counts(const Counts& counts) {
  std::string bound;
  if (counts.generic)
    bound = summary_line(
        "generic", amount(*counts.generic, "class", "classes") + " at generic lengths" +
                       (counts.at_infinity && (!counts.paths || Natural(*counts.paths) == *counts.generic)
                            ? fmt::format(", of which {} at infinity here", *counts.at_infinity)
                            : ""));
  if (!counts.paths) return bound;
  std::string text = amount(*counts.paths, "path", "paths");
  if (counts.at_infinity.value_or(0) > 0) text += fmt::format(", {} to infinity", *counts.at_infinity);
  if (counts.failed_paths.value_or(0) > 0) text += fmt::format(", {} without an end", *counts.failed_paths);
  return bound + summary_line("tracked", text);
}

/// "1/(1-t)", "1/(1-t)^2", "1/(1-t)^(1/2)"
std::string growth(const Exponent& exponent) {
  if (exponent.denominator > 1)
    return fmt::format("1/(1-t)^({}/{})", exponent.numerator, exponent.denominator);
  return exponent.numerator == 1 ? "1/(1-t)" : fmt::format("1/(1-t)^{}", exponent.numerator);
}

/// "1600 paths like 1/(1-t), 32 like 1/(1-t)^2"; empty where no growth is known.
std::string growths(const std::vector<PathEnds>& all) {
  std::map<Exponent, std::uint64_t> counts;
  for (const PathEnds& ends : all)
    if (const auto known = exponent(ends)) counts[*known] += ends.paths;
  std::string text;
  for (const auto& [known, paths] : counts)
    text += (text.empty() ? amount(paths, "path", "paths") : fmt::format(", {}", paths)) + " like " +
            growth(known);
  return text.empty() ? "" : summary_line("at infinity", text);
}

/// Empty where nothing is proven.
std::string path_proofs(const std::vector<PathEnds>& all) {
  std::uint64_t proven = 0;
  for (const PathEnds& ends : all) proven += ends.proven ? ends.paths : 0;
  if (proven == 0) return "";
  return summary_line("proven", amount(proven, "path closes", "paths close") +
                                    "; the order and number of crossings are those of S");
}

std::string crossings_table(const Assessment& assessment) {
  if (assessment.crossings.empty()) return "";
  std::string text =
      "\n  crossings of t = 1 in the order met\n  number  solution  t goes   residual   condition\n";
  const std::size_t shown = std::min(assessment.crossings.size(), shown_crossings);
  for (std::size_t i = 0; i < shown; ++i) {
    const AssessedCrossing& crossing = assessment.crossings[i];
    const std::string_view sense = crossing.direction > 0 ? "up" : "down";
    if (!crossing.solution) {
      text += fmt::format("  {:6}  {:>8}  {:<6}\n", i, "-", sense);
      continue;
    }
    const AssessedSolution& solution = assessment.solutions[*crossing.solution];
    text += fmt::format("  {:6}  {:8}  {:<6}  {:9.2g}  {:10.3g}\n", i, *crossing.solution, sense,
                        solution.residual, solution.condition);
  }
  const std::size_t hidden = assessment.crossings.size() - shown;
  return text + (hidden > 0 ? fmt::format("  and {} more (--out FILE lists all)\n\n", hidden) : "\n");
}

template <typename Member>
std::string range(const std::vector<AssessedSolution>& solutions, Member member) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const AssessedSolution& solution : solutions) {
    low = std::min(low, std::invoke(member, solution));
    high = std::max(high, std::invoke(member, solution));
  }
  return fmt::format("{:.2g} to {:.2g}", low, high);
}

/// Those that doubles do not hold.
std::string far_ones(const std::vector<AssessedSolution>& solutions) {
  const auto count = static_cast<std::uint64_t>(
      std::ranges::count_if(solutions, [](const AssessedSolution& one) { return one.decimals != nullptr; }));
  if (count == 0) return "";
  return summary_line("far", fmt::format("{} with coordinates {}: a result has them as decimals too",
                                         amount(count, "solution", "solutions"), too_large_for_doubles()));
}

std::string condition_and_residual(const std::vector<AssessedSolution>& solutions) {
  if (solutions.empty()) return "";
  const bool certified = std::all_of(solutions.begin(), solutions.end(),
                                     [](const AssessedSolution& s) { return s.error_bound.has_value(); });
  std::string text;
  if (certified)
    text = summary_line("error", range(solutions, [](const AssessedSolution& s) { return *s.error(); }) +
                                     ", proven, in the file's unit of length");
  return text + far_ones(solutions) +
         summary_line("residual",
                      range(solutions, &AssessedSolution::residual) + ", relative to the lengths") +
         summary_line("condition",
                      range(solutions, &AssessedSolution::condition) + ", of the scaled Jacobian");
}

/// [I] measures steps in the file's unit of length.
std::string_view step_unit(const OptionMap& options) {
  const auto mode = options.find("mode");
  return mode != options.end() && mode->second == "paper" ? "the file's unit" : "units of the scene";
}

/// The counters that are not zero, in the order of the result file.
std::string work(const SolveRun& run) {
  const WorkCounters& counters = run.work;
  std::string text;
  const auto append = [&](std::int64_t count, std::string_view what) {
    if (count != 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  append(counters.iterations, "iterations");
  append(counters.rejected_steps, "rejected steps");
  append(counters.newton_iterations, "Newton iterations");
  append(counters.evaluations, "evaluations");
  append(counters.partial_evaluations, "partial evaluations");
  append(counters.jacobians, "Jacobians");
  append(counters.factorisations, "factorisations");
  append(counters.plan_changes, "plan changes");
  std::string lines = text.empty() ? "" : summary_line("work", text);
  if (counters.smallest_step)
    lines += summary_line("smallest step",
                          fmt::format("{:.3g}, in {}", *counters.smallest_step, step_unit(run.options)));
  if (counters.mean_driving_parameters && counters.max_driving_parameters)
    lines += summary_line(
        "driving", fmt::format("{:.3g} parameters on average, {} at most", *counters.mean_driving_parameters,
                               *counters.max_driving_parameters));
  return lines;
}

/// "coarse solutions 224, refined solutions 24"
std::string particulars(const std::vector<Particular>& counts) {
  std::string text;
  for (const Particular& count : counts) {
    std::string name = count.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count.value);
  }
  return text.empty() ? "" : summary_line("counted", text);
}

/// ", certified in 18.9 s, 0.72 ms of a thread for each", of the generic solutions too.
std::string certifying_time(const SolveRun& run) {
  const std::optional<Proofs>& proofs = run.proofs;
  if (!run.timing.certify_s || !proofs || proofs->why_none) return "";
  const double total_s = *run.timing.certify_s;
  const auto all = static_cast<double>(run.solutions.size() + proofs->generic.value_or(0));
  const std::string each =
      all > 0 ? fmt::format(", {:.3g} ms of a thread for each", 1e3 * total_s * run.threads / all) : "";
  return fmt::format(", certified in {:.3g} s{}", total_s, each);
}

std::string time(const SolveRun& run) {
  const Timing& timing = run.timing;
  const std::string recalled =
      timing.recalled_steps == 0
          ? ""
          : fmt::format(", after recalling {} from the journal",
                        amount(static_cast<std::uint64_t>(timing.recalled_steps), "step", "steps"));
  return summary_line("time", fmt::format("{:.3g} s (cpu {:.3g} s), prepared in {:.3g} s{}{}", timing.wall_s,
                                          timing.cpu_s, timing.prepare_s, recalled, certifying_time(run)));
}

std::string failed_checks(const std::vector<FailedCheck>& checks) {
  return checks.empty()
             ? ""
             : summary_line("checks", amount(checks.size(), "check does", "checks do") + " not hold");
}

std::string proofs_text(const Assessment& assessment) {
  if (!assessment.proofs) return "";
  return certificates_text(*assessment.proofs, assessment.solutions.size(),
                           assessment.counts.complex_up_to_reflection.has_value());
}

}  // namespace

std::string solve_summary(const Instance& instance, const SolveRun& run) {
  const Assessment& assessment = run;
  return headline(instance, run) + foreign_claim(run) +
         solution_counts(instance.problem, assessment.counts, run.claim) +
         solutions_found(instance.problem, assessment, run.claim) +
         standings_text(instance.problem, assessment) + path_counts(assessment.counts) +
         proofs_text(assessment) + growths(assessment.ends) + path_proofs(assessment.ends) +
         crossings_table(assessment) + condition_and_residual(assessment.solutions) +
         particulars(run.particulars) + work(run) + time(run) + failed_checks(assessment.failed_checks);
}

}  // namespace gcs
