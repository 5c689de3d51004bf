/// Every strategy on every shipped instance against the contract.

#include "harness/tests/contract/strategy_contract.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/contract/count_limits.hpp"
#include "harness/tests/contract/report_agreement.hpp"

using namespace gcs;
using namespace gcs::contract;

namespace {

/// Their paths are long, or their solutions many: they take part where one solve suffices.
const std::vector<std::string> large{"icosahedron", "icosahedron-printed", "three-points-three-lines-angles",
                                     "three-points-three-lines-distances"};

/// Where the Euler-Newton tracker of the papers keeps to the path.
const std::vector<std::string> published_mode{"dodecagon", "k33", "octahedron", "qk33"};

bool is_in(const std::vector<std::string>& list, const std::string& id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

std::vector<Instance> small_instances() {
  std::vector<Instance> instances;
  for (const std::string& id : shipped_instances())
    if (!is_in(large, id)) instances.push_back(load_instance(id));
  return instances;
}

/// Whether the strategy has an option of that name with this value among others.
bool has_choice(const StrategyEntry& entry, std::string_view name, std::string_view value) {
  return std::any_of(entry.options.begin(), entry.options.end(), [&](const OptionSpec& option) {
    return option.name == name &&
           ("|" + option.allowed + "|").find("|" + std::string(value) + "|") != std::string::npos;
  });
}

/// All strategies, those with a direct method by homotopy and by the paths of published systems, and those that can
/// prove a path so as well.
std::vector<Subject> subjects() {
  std::vector<Subject> result;
  for (const StrategyEntry& entry : all_strategies()) {
    result.push_back({entry});
    if (has_choice(entry, "method", "homotopy")) result.push_back({entry, {{"method", "homotopy"}}});
    if (has_choice(entry, "system", "cubic"))
      for (const char* system : {"quadrics", "cubic"})
        result.push_back({entry, {{"method", "published"}, {"system", system}}});
    if (has_choice(entry, "mode", "certified")) result.push_back({entry, {{"mode", "certified"}}});
  }
  return result;
}

/// The strategies that track S as published too.
std::vector<Subject> published_subjects() {
  std::vector<Subject> result;
  for (const StrategyEntry& entry : all_strategies())
    if (has_choice(entry, "mode", "paper")) result.push_back({entry, {{"mode", "paper"}}});
  return result;
}

/// Fails for every violation, with the strategy's and the instance's names.
void expect_none(const Subject& subject, const std::string& instance, const Violations& violations) {
  INFO(subject.label() << " on " << instance << "\n" << in_words(violations));
  CHECK(violations.empty());
}

/// Calls `check` with every strategy and every small instance that it supports.
template <class Check>
void on_small_instances(const Check& check) {
  const std::vector<Instance> instances = small_instances();
  for (const Subject& subject : subjects())
    for (const Instance& instance : instances) {
      const Scene scene(instance.problem);
      if (supports(subject, scene)) expect_none(subject, instance.id, check(subject, instance, scene));
    }
}

struct SubjectReport {
  Subject subject;
  SolveReport report;
};

/// All complex ones.
bool lists_multiple_solutions_alone(const SolveReport& report) {
  return report.status == SolveStatus::complete && report.claim == Claim::all_complex &&
         !report.candidates.empty() &&
         std::ranges::all_of(report.candidates, [](const Candidate& one) { return one.multiplicity > 1; });
}

/// What each subject that supports the scene reports, checked for itself.
std::vector<SubjectReport> reports_on(const Scene& scene, const TheoreticalCounts& counts,
                                      const std::vector<Subject>& all, const std::string& instance) {
  std::vector<SubjectReport> reports;
  for (const Subject& subject : all) {
    if (!supports(subject, scene)) continue;
    reports.push_back({subject, solve_anew(subject, scene)});
    const SolveReport& report = reports.back().report;
    expect_none(subject, instance, check_report(scene, report));
    expect_none(subject, instance, check_limits(scene, counts, report));
  }
  const bool has_simple_solutions = std::ranges::none_of(
      reports, [](const SubjectReport& one) { return lists_multiple_solutions_alone(one.report); });
  for (const auto& [subject, report] : reports)
    expect_none(subject, instance, check_completion(report, has_simple_solutions));
  return reports;
}

void check_agreement(const Scene& scene, const std::vector<SubjectReport>& reports,
                     const std::string& instance) {
  for (std::size_t j = 0; j < reports.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const auto found = contradiction(scene, reports[i].report, reports[j].report);
      INFO(reports[i].subject.label()
           << " and " << reports[j].subject.label() << " on " << instance << ": " << found.value_or(""));
      CHECK_FALSE(found);
    }
}

/// A tenth of a second or so.
constexpr std::int64_t much_work = 20000;

/// What a solve took, and the instance.
using Solved = std::pair<std::int64_t, std::string>;

/// All that is not much work, and of the rest the third that is least.
std::vector<std::string> cheaper(std::vector<Solved> solved) {
  std::sort(solved.begin(), solved.end());
  const auto laborious = std::lower_bound(solved.begin(), solved.end(), Solved{much_work, ""});
  solved.erase(laborious + (solved.end() - laborious) / 3, solved.end());
  std::vector<std::string> instances;
  for (const auto& [work, instance] : solved) instances.push_back(instance);
  return instances;
}

}  // namespace

// One test, since each solve of all instances by all strategies is half a minute.
TEST_CASE("all instances are solved as claimed, stopped, repeated and restated, and strategies agree") {
  std::map<std::string, std::vector<Solved>> solved_by;
  for (const std::string& id : shipped_instances()) {
    std::vector<Subject> all = subjects();
    if (is_in(published_mode, id))
      for (const Subject& subject : published_subjects()) all.push_back(subject);
    const ProblemStatement problem = load_instance(id).problem;
    const Scene scene(problem);
    for (const Subject& subject : all) expect_none(subject, id, check_refusal(subject, scene));
    const std::vector<SubjectReport> reports = reports_on(scene, theoretical_counts(problem), all, id);
    for (const auto& [subject, report] : reports) {
      INFO(subject.label());
      CHECK(in_words(check_counts(id, scene, report)) == "");
      CHECK(in_words(check_certificates(scene, report)) == "");
      expect_none(subject, id, check_stop(subject, scene, report));
      if (!is_in(large, id)) solved_by[subject.label()].emplace_back(effort(report.work), id);
    }
    check_agreement(scene, reports, id);
  }

  std::mt19937_64 random(20160101);
  const Scene other(load_instance("octahedron").problem);
  for (const Subject& subject : subjects())
    for (const std::string& id : cheaper(solved_by[subject.label()])) {
      const ProblemStatement problem = load_instance(id).problem;
      expect_none(subject, id, check_repeatability(subject, Scene(problem), other));
      expect_none(subject, id, check_restatements(subject, problem, restatements(problem, random)));
    }
}

TEST_CASE("every strategy supports an instance") {
  const std::vector<Instance> instances = small_instances();
  for (const Subject& subject : subjects()) {
    INFO(subject.label());
    CHECK(std::any_of(instances.begin(), instances.end(),
                      [&](const Instance& instance) { return supports(subject, Scene(instance.problem)); }));
  }
}

TEST_CASE("what was prepared serves other lengths") {
  std::mt19937_64 random(2016);
  on_small_instances([&](const Subject& subject, const Instance& instance, const Scene& scene) {
    if (!instance.problem.sketch || !instance.problem.lines.empty()) return Violations{};
    ProblemStatement other = with_random_targets(instance.problem, random);
    other.interpolation = instance.problem.interpolation;
    return check_reuse(subject, scene, Scene(other));
  });
}

TEST_CASE("a long path does not depend on names and units") {
  std::mt19937_64 random(12);
  const ProblemStatement problem = load_instance("icosahedron").problem;
  const std::vector<Restatement> names_and_units{relabelled(problem, random), scaled(problem, -3)};
  for (const Subject& subject : subjects())
    expect_none(subject, "icosahedron", check_restatements(subject, problem, names_and_units));
}

TEST_CASE("all strategies agree on random lengths") {
  std::mt19937_64 random(8705);
  for (const std::string id : {"k33", "octahedron", "dodecagon", "disulfide"}) {
    const ProblemStatement problem = load_instance(id).problem;
    const TheoreticalCounts counts = theoretical_counts(problem);
    std::size_t solutions = 0;
    for (int i = 0; i < 8; ++i) {
      const Scene scene(with_random_targets(problem, random));
      const std::string name = id + " with random lengths " + std::to_string(i);
      const std::vector<SubjectReport> reports = reports_on(scene, counts, subjects(), name);
      check_agreement(scene, reports, name);
      for (const SubjectReport& one : reports) solutions += one.report.candidates.size();
    }
    CHECK(solutions > 0);
  }
}
