/// The contract's checks catch what they are there for: every wrong strategy stands before the test in which
/// it is caught.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/contract/spoiled_strategy.hpp"
#include "harness/tests/contract/strategy_contract.hpp"
#include "solvers/figures/residual_and_condition.hpp"

using namespace gcs;
using namespace gcs::contract;

namespace {

using Checks = std::set<std::string>;

Checks names_of(const Violations& violations) {
  Checks names;
  for (const Violation& violation : violations) names.insert(violation.check);
  return names;
}

const Scene& octahedron() {
  static const Scene scene(load_instance("octahedron").problem);
  return scene;
}

const Scene& disulfide() {
  static const Scene scene(load_instance("disulfide").problem);
  return scene;
}

/// The checks that one report on the octahedron does not pass.
Checks caught_by_report(const StrategyEntry& entry) {
  const SolveReport report = solve_anew({entry}, octahedron());
  Checks names = names_of(check_report(octahedron(), report));
  names.merge(names_of(check_counts("octahedron", octahedron(), report)));
  return names;
}

Checks caught_by_support(const StrategyEntry& entry) {
  Checks names = names_of(check_refusal({entry}, octahedron()));
  names.merge(names_of(check_completion(solve_anew({entry}, octahedron()))));
  return names;
}

Checks caught_by_repeatability(const StrategyEntry& entry) {
  return names_of(check_repeatability({entry}, octahedron(), disulfide()));
}

Checks caught_by_stop(const StrategyEntry& entry) {
  return names_of(check_stop({entry}, octahedron(), solve_anew({entry}, octahedron())));
}

Checks caught_by_restatements(const StrategyEntry& entry) {
  std::mt19937_64 random(1);
  return names_of(
      check_restatements({entry}, octahedron().problem(), restatements(octahedron().problem(), random)));
}

/// Removes everything found, which leaves nothing that could contradict itself.
void forget(SolveReport& report) {
  report.candidates.clear();
  report.paths[0].crossings.clear();
}

void change_last_bit(SolveReport& report) {
  double& x = report.candidates[0].figure.points(0, 1);
  x = std::nextafter(x, std::numeric_limits<double>::infinity());
}

}  // namespace

TEST_CASE("the sound strategy passes every check") {
  CHECK(caught_by_report(sound_strategy()).empty());
  CHECK(caught_by_support(sound_strategy()).empty());
  CHECK(caught_by_repeatability(sound_strategy()).empty());
  CHECK(caught_by_stop(sound_strategy()).empty());
  CHECK(caught_by_restatements(sound_strategy()).empty());
}

namespace {

void mirror_a_coordinate(SolveReport& report, const Circumstances&) {
  report.candidates[0].figure.points(1, 3) *= -1;
}

void move_a_point(SolveReport& report, const Circumstances&) {
  report.candidates[0].figure.points(0, 3) += 1e-11;
}

}  // namespace

TEST_CASE("a point out of its place is caught by its residual") {
  CHECK(caught_by_report(spoiled<mirror_a_coordinate>()).count("residual") == 1);
  CHECK(caught_by_report(spoiled<move_a_point>()).count("residual") == 1);
}

namespace {

template <int percent>
void state_a_condition(SolveReport& report, const Circumstances&) {
  Candidate& candidate = report.candidates[0];
  candidate.condition = jacobian_condition(octahedron(), candidate.figure) * percent / 100;
}

}  // namespace

TEST_CASE("a condition number that is stated is that of the figure") {
  CHECK(caught_by_report(spoiled<state_a_condition<100>>()).empty());
  CHECK(caught_by_report(spoiled<state_a_condition<101>>()).count("condition") == 1);
}

namespace {

void drop_a_crossing(SolveReport& report, const Circumstances&) {
  report.candidates.erase(report.candidates.begin());
  std::vector<Crossing>& crossings = report.paths[0].crossings;
  crossings.erase(crossings.begin());
  for (Crossing& crossing : crossings) --crossing.candidate;
}

void drop_everything(SolveReport& report, const Circumstances&) { forget(report); }

}  // namespace

TEST_CASE("a lost solution is caught by the directions of its neighbours or by the count") {
  CHECK(caught_by_report(spoiled<drop_a_crossing>()).count("alternation") == 1);
  CHECK(caught_by_report(spoiled<drop_everything>()) == Checks{"count"});
}

namespace {

void repeat_a_solution(SolveReport& report, const Circumstances&) {
  report.candidates.push_back(Candidate(report.candidates[0]));
}

void repeat_the_round(SolveReport& report, const Circumstances&) {
  const std::vector<Crossing> round = report.paths[0].crossings;
  for (const auto& [candidate, direction] : round) {
    report.paths[0].crossings.push_back({static_cast<int>(report.candidates.size()), direction});
    report.candidates.push_back(Candidate(report.candidates[candidate]));
  }
}

}  // namespace

TEST_CASE("a solution given twice is caught as a duplicate") {
  CHECK(caught_by_report(spoiled<repeat_a_solution>()).count("duplicate") == 1);
  CHECK(caught_by_report(spoiled<repeat_the_round>()).count("duplicate") == 1);
}

namespace {

void name_an_unknown_candidate(SolveReport& report, const Circumstances&) {
  report.paths[0].crossings.back().candidate = static_cast<int>(report.candidates.size());
}

void lose_a_point(SolveReport& report, const Circumstances&) {
  report.candidates[0].figure.points.conservativeResize(3, 5);
}

void place_a_point_nowhere(SolveReport& report, const Circumstances&) {
  report.candidates[0].figure.points(0, 3) = std::numeric_limits<double>::quiet_NaN();
}

void count_twice(SolveReport& report, const Circumstances&) {
  report.particulars = {{"samples", 1}, {"samples", 2}};
}

}  // namespace

TEST_CASE("what cannot be read is caught as malformed") {
  CHECK(caught_by_report(spoiled<name_an_unknown_candidate>()).count("malformed") == 1);
  CHECK(caught_by_report(spoiled<lose_a_point>()).count("malformed") == 1);
  CHECK(caught_by_report(spoiled<place_a_point_nowhere>()).count("malformed") == 1);
  CHECK(caught_by_report(spoiled<count_twice>()).count("malformed") == 1);
}

namespace {

void hide_a_failed_path(SolveReport& report, const Circumstances&) {
  report.paths[0].end = PathRecord::End::failed;
}

void fail_without_a_reason(SolveReport& report, const Circumstances&) {
  report.status = SolveStatus::partial;
}

}  // namespace

TEST_CASE("a failure without a word is caught by its status") {
  CHECK(caught_by_report(spoiled<hide_a_failed_path>()).count("status") == 1);
  CHECK(caught_by_report(spoiled<fail_without_a_reason>()) == Checks{"status"});
}

namespace {

void claim_too_much(SolveReport& report, const Circumstances&) { report.claim = Claim::all_real; }

}  // namespace

TEST_CASE("a claim that is not met is caught by the count") {
  const SolveReport report = solve_anew({spoiled<claim_too_much>()}, disulfide());
  CHECK(check_report(disulfide(), report).empty());
  CHECK(names_of(check_counts("disulfide", disulfide(), report)) == Checks{"count"});
}

namespace {

/// Far enough for the harness to take it for another class.
void give_a_neighbour(SolveReport& report, const Circumstances&) {
  report.candidates.push_back(report.candidates[0]);
  report.candidates.back().figure.points(0, 3) += 1e-6;
}

}  // namespace

TEST_CASE("a point next to a solution is caught by the certificate as the same class") {
  const SolveReport sound = solve_anew({sound_strategy()}, octahedron());
  CHECK(check_certificates(octahedron(), sound).empty());
  const SolveReport report = solve_anew({spoiled<give_a_neighbour>()}, octahedron());
  CHECK(names_of(check_certificates(octahedron(), report)) == Checks{"certificate"});
}

namespace {

void give_up(SolveReport& report, const Circumstances&) {
  report = {};
  report.reason = "it is too hard";
}

class Mute final : public Strategy {
 public:
  explicit Mute(const OptionMap&) {}
  std::optional<std::string> why_unsupported(const SolveRequest&) const override { return "no"; }
  SolveReport solve(const SolveRequest& request) override {
    return sound_strategy().make(complete_options(sound_strategy(), {}))->solve(request);
  }
};

}  // namespace

TEST_CASE("giving up, and refusing without a sentence, are caught by the support") {
  CHECK(caught_by_support(spoiled<give_up>()) == Checks{"support"});
  CHECK(caught_by_support(wrong_entry<Mute>()) == Checks{"support"});
}

namespace {

void change_with_calls(SolveReport& report, const Circumstances& now) {
  if (now.call > 0) change_last_bit(report);
}

void change_with_objects(SolveReport& report, const Circumstances& now) {
  report.work.evaluations += now.object;
}

void change_with_threads(SolveReport& report, const Circumstances& now) {
  report.work.factorisations += now.request.threads;
}

void change_when_watched(SolveReport& report, const Circumstances& now) {
  if (now.request.monitor) report.paths[0].length *= 2;
}

void change_with_other_scenes(SolveReport& report, const Circumstances& now) {
  if (now.saw_other_scene) std::swap(report.candidates.front(), report.candidates.back());
}

}  // namespace

TEST_CASE("what changes between two solves is caught as not repeatable") {
  const Checks repeatable{"repeatable"};
  CHECK(caught_by_repeatability(spoiled<change_with_calls>()) == repeatable);
  CHECK(caught_by_repeatability(spoiled<change_with_objects>()) == repeatable);
  CHECK(caught_by_repeatability(spoiled<change_with_threads>()) == repeatable);
  CHECK(caught_by_repeatability(spoiled<change_when_watched>()) == repeatable);
  CHECK(caught_by_repeatability(spoiled<change_with_other_scenes>()) == repeatable);
}

namespace {

/// Solves what it prepared, whatever it is asked.
class Stubborn final : public Strategy {
 public:
  explicit Stubborn(const OptionMap& options) : sound_(sound_strategy().make(options)) {}
  std::optional<std::string> why_unsupported(const SolveRequest&) const override { return std::nullopt; }
  void prepare(const SolveRequest& request) override { prepared_.emplace(request.scene.problem()); }
  SolveReport solve(const SolveRequest&) override { return sound_->solve(*prepared_); }

 private:
  std::unique_ptr<Strategy> sound_;
  std::optional<Scene> prepared_;
};

}  // namespace

TEST_CASE("solving what was prepared instead of what is asked is caught as a wrong reuse") {
  std::mt19937_64 random(1);
  const Scene other(with_random_targets(octahedron().problem(), random));
  CHECK(names_of(check_reuse({wrong_entry<Stubborn>()}, octahedron(), other)) == Checks{"reuse"});
  CHECK(check_reuse({sound_strategy()}, octahedron(), other).empty());
}

namespace {

void say_nothing(SolveReport&, const Circumstances&) {}

void pretend_to_stop(SolveReport& report, const Circumstances& now) {
  if (!now.request.stop.stop_requested()) return;
  report.status = SolveStatus::stopped;
  report.reason = "stopped on request";
  report.paths[0].end = PathRecord::End::stopped;
  report.paths[0].cause = report.reason;
}

void make_things_up(SolveReport& report, const Circumstances& now) {
  if (report.status == SolveStatus::stopped) report.candidates.push_back({*now.request.scene.sketch(), 1});
}

/// Hears of a stop at the beginning only.
class HardOfHearing final : public Strategy {
 public:
  explicit HardOfHearing(const OptionMap& options) : sound_(sound_strategy().make(options)) {}
  std::optional<std::string> why_unsupported(const SolveRequest&) const override { return std::nullopt; }
  SolveReport solve(const SolveRequest& request) override {
    const SolveRequest deaf(request.scene, {.monitor = request.monitor});
    return sound_->solve(request.stop.stop_requested() ? request : deaf);
  }

 private:
  std::unique_ptr<Strategy> sound_;
};

}  // namespace

TEST_CASE("not stopping, and not honestly, are caught") {
  const Checks stop{"stop"};
  CHECK(caught_by_stop(deaf<say_nothing>()) == stop);
  CHECK(caught_by_stop(deaf<pretend_to_stop>()) == stop);
  CHECK(caught_by_stop(spoiled<make_things_up>()) == stop);
  const Scene long_path(load_instance("icosahedron").problem);
  const Subject hard_of_hearing{wrong_entry<HardOfHearing>()};
  CHECK(names_of(check_stop(hard_of_hearing, long_path, solve_anew(hard_of_hearing, long_path))) == stop);
}

namespace {

void go_by_names(SolveReport& report, const Circumstances& now) {
  if (now.request.scene.problem().points[0] != "p1") forget(report);
}

void go_by_order(SolveReport& report, const Circumstances& now) {
  if (now.request.scene.problem().constraints[0].id != "a1") forget(report);
}

void go_by_side(SolveReport& report, const Circumstances& now) {
  if (now.request.scene.problem().sketch->points.row(0).sum() < 0) forget(report);
}

void go_by_ends(SolveReport& report, const Circumstances& now) {
  const auto is_descending = [](const DistanceConstraint& c) { return c.between[0] > c.between[1]; };
  const auto& constraints = now.request.scene.problem().constraints;
  if (std::all_of(constraints.begin(), constraints.end(), is_descending)) forget(report);
}

void go_by_unit(SolveReport& report, const Circumstances& now) {
  if (now.request.scene.unit_exponent() > 3) change_last_bit(report);
}

}  // namespace

TEST_CASE("what depends on how a problem is stated is caught by that restatement") {
  CHECK(caught_by_restatements(spoiled<go_by_names>()) == Checks{"relabelled"});
  CHECK(caught_by_restatements(spoiled<go_by_order>()) == Checks{"constraints permuted"});
  CHECK(caught_by_restatements(spoiled<go_by_side>()) == Checks{"mirrored"});
  CHECK(caught_by_restatements(spoiled<go_by_ends>()) == Checks{"ends swapped"});
  CHECK(caught_by_restatements(spoiled<go_by_unit>()) == Checks{"scaled"});
}
