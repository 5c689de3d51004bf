/// Every strategy on every shipped instance against the contract.

#include "harness/tests/contract/strategy_contract.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

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

/// A tenth of a second or so.
constexpr std::int64_t much_work = 20000;

/// The instances that the subject supports, least work first, and of those that are much work to it the third that is
/// least.
std::vector<Instance> cheaper_instances(const Subject& subject, const std::vector<Instance>& instances) {
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  for (std::size_t i = 0; i < instances.size(); ++i)
    if (const Scene scene(instances[i].problem); supports(subject, scene))
      order.emplace_back(effort(solve_anew(subject, scene).work), i);
  std::sort(order.begin(), order.end());
  const auto laborious = std::lower_bound(order.begin(), order.end(), std::pair{much_work, std::size_t{0}});
  order.erase(laborious + (order.end() - laborious) / 3, order.end());
  std::vector<Instance> cheaper;
  for (const auto& [work, i] : order) cheaper.push_back(instances[i]);
  return cheaper;
}

/// The same for checks that solve many times.
template <class Check>
void on_cheaper_instances(const Check& check) {
  const std::vector<Instance> instances = small_instances();
  for (const Subject& subject : subjects())
    for (const Instance& instance : cheaper_instances(subject, instances))
      expect_none(subject, instance.id, check(subject, instance, Scene(instance.problem)));
}

struct LabelledReport {
  std::string label;
  SolveReport report;
};

/// All complex ones.
bool lists_multiple_solutions_alone(const SolveReport& report) {
  return report.status == SolveStatus::complete && report.claim == Claim::all_complex &&
         !report.candidates.empty() &&
         std::ranges::all_of(report.candidates, [](const Candidate& one) { return one.multiplicity > 1; });
}

/// What each subject that supports the scene reports, checked for itself.
std::vector<LabelledReport> reports_on(const Scene& scene, const TheoreticalCounts& counts,
                                       const std::vector<Subject>& all, const std::string& instance) {
  std::vector<LabelledReport> reports;
  std::vector<const Subject*> solved_by;
  for (const Subject& subject : all) {
    if (!supports(subject, scene)) continue;
    reports.push_back({subject.label(), solve_anew(subject, scene)});
    const SolveReport& report = reports.back().report;
    solved_by.push_back(&subject);
    expect_none(subject, instance, check_report(scene, report));
    expect_none(subject, instance, check_limits(scene, counts, report));
  }
  const bool has_simple_solutions = std::ranges::none_of(
      reports, [](const LabelledReport& one) { return lists_multiple_solutions_alone(one.report); });
  for (std::size_t i = 0; i < reports.size(); ++i)
    expect_none(*solved_by[i], instance, check_completion(reports[i].report, has_simple_solutions));
  return reports;
}

void check_agreement(const Scene& scene, const std::vector<LabelledReport>& reports,
                     const std::string& instance) {
  for (std::size_t j = 0; j < reports.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const auto found = contradiction(scene, reports[i].report, reports[j].report);
      INFO(reports[i].label << " and " << reports[j].label << " on " << instance << ": "
                            << found.value_or(""));
      CHECK_FALSE(found);
    }
}

}  // namespace

TEST_CASE("every instance is solved as claimed or refused with a sentence, and all strategies agree") {
  for (const std::string& id : shipped_instances()) {
    std::vector<Subject> all = subjects();
    if (is_in(published_mode, id))
      for (const Subject& subject : published_subjects()) all.push_back(subject);
    const ProblemStatement problem = load_instance(id).problem;
    const Scene scene(problem);
    for (const Subject& subject : all) expect_none(subject, id, check_refusal(subject, scene));
    const std::vector<LabelledReport> reports = reports_on(scene, theoretical_counts(problem), all, id);
    for (const auto& [label, report] : reports) {
      INFO(label);
      CHECK(in_words(check_counts(id, scene, report)) == "");
      CHECK(in_words(check_certificates(scene, report)) == "");
    }
    check_agreement(scene, reports, id);
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

TEST_CASE("a solve can be repeated bit for bit") {
  const Scene other(load_instance("octahedron").problem);
  on_cheaper_instances([&](const Subject& subject, const Instance&, const Scene& scene) {
    return check_repeatability(subject, scene, other);
  });
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

TEST_CASE("a strategy stops when it is asked to") {
  on_small_instances(
      [](const Subject& subject, const Instance&, const Scene& scene) { return check_stop(subject, scene); });
}

TEST_CASE("a long solve stops on the way") {
  const Scene scene(load_instance("icosahedron").problem);
  for (const Subject& subject : subjects())
    if (supports(subject, scene)) expect_none(subject, "icosahedron", check_stop(subject, scene));
}

TEST_CASE("neither names, orders, mirrors nor units matter") {
  std::mt19937_64 random(20160101);
  on_cheaper_instances([&](const Subject& subject, const Instance& instance, const Scene&) {
    return check_restatements(subject, instance.problem, restatements(instance.problem, random));
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
      const std::vector<LabelledReport> reports = reports_on(scene, counts, subjects(), name);
      check_agreement(scene, reports, name);
      for (const auto& [label, report] : reports) solutions += report.candidates.size();
    }
    CHECK(solutions > 0);
  }
}
