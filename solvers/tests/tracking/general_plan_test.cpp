/// S of general scenes in the driving parameters of plans, against S in all coordinates.

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "solvers/construction/element_plan.hpp"
#include "solvers/construction/plan_blocks.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/elements/measured_scenes.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

std::vector<NamedProblem> scenes_with_plans(std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<NamedProblem> scenes = measured_scenes(random);
  for (const int planes : {1, 2, 3}) {
    const ProblemStatement problem = random_octahedral(planes, random);
    scenes.push_back({std::to_string(planes) + " planes", sketched(problem, random)});
  }
  scenes.push_back({"3p3L", sketched_points_and_lines(random)});
  return scenes;
}

Answer by_plan(const ProblemStatement& problem, const OptionMap& options = {}) {
  return solve(Scene::unchecked(problem), "rcp", options);
}

std::vector<int> directions(const Answer& answer) {
  std::vector<int> result;
  for (const AssessedCrossing& crossing : answer.crossings) result.push_back(crossing.direction);
  return result;
}

}  // namespace

TEST_CASE("plans and all coordinates meet the same solutions of general scenes in the same order") {
  std::size_t met = 0;
  std::int64_t changes = 0;
  for (const std::uint64_t seed : {41U, 42U, 43U, 44U})
    for (const auto& [name, problem] : scenes_with_plans(seed)) {
      const Answer expected = followed(problem), answer = by_plan(problem);
      CAPTURE(name, seed, expected.reason, answer.reason);
      CHECK(answer.status == expected.status);
      CHECK(answer.failed_checks.empty());
      CHECK(answer.work.max_driving_parameters.value_or(0) > 0);
      CHECK(directions(answer) == directions(expected));
      check_same_crossings(Scene::unchecked(problem), crossed(answer), crossed(expected));
      met += answer.crossings.size();
      changes += answer.work.plan_changes;
    }
  CHECK(met >= 20);
  CHECK(changes >= 20);
}

TEST_CASE("names, orders and units of a general scene do not change what plans meet") {
  std::size_t met = 0;
  for (const auto& [name, problem] : scenes_with_plans(41)) {
    const std::vector<Figure> expected = crossed(by_plan(problem));
    CAPTURE(name);
    check_same_crossings(Scene::unchecked(problem), crossed(by_plan(renamed_and_scaled(problem))), expected);
    met += expected.size();
  }
  CHECK(met > 0);
}

TEST_CASE("where plans are changed does not change what they meet in general scenes") {
  for (const auto& [name, problem] : scenes_with_plans(42)) {
    const Answer expected = by_plan(problem);
    for (const OptionMap& options :
         {OptionMap{{"alpha", "0.02"}}, OptionMap{{"alpha", "0.3"}}, OptionMap{{"order", "20"}}}) {
      CAPTURE(name, options.begin()->first, options.begin()->second);
      check_same_crossings(Scene::unchecked(problem), crossed(by_plan(problem, options)), crossed(expected));
    }
    const Answer kept = by_plan(problem, {{"swap", "off"}});
    CHECK(kept.work.plan_changes == 0);
    if (kept.status == RunStatus::complete)
      check_same_crossings(Scene::unchecked(problem), crossed(kept), crossed(expected));
  }
}

TEST_CASE("every unknown and every equation of a general scene is in one block of its plan") {
  for (const auto& [name, problem] : scenes_with_plans(43)) {
    const Scene scene = Scene::unchecked(problem);
    REQUIRE_FALSE(why_no_element_plan(scene, Instructions::one_place));
    const ElementPlan plan = derive_element_plan(scene, Instructions::one_place);
    const SceneSystem system(scene);
    std::vector<int> unknowns, equations, all(static_cast<std::size_t>(system.equations().unknowns));
    for (const PlanBlock& block : plan_blocks(system, plan)) {
      unknowns.insert(unknowns.end(), block.unknowns.begin(), block.unknowns.end());
      equations.insert(equations.end(), block.equations.begin(), block.equations.end());
    }
    std::ranges::sort(unknowns);
    std::ranges::sort(equations);
    std::iota(all.begin(), all.end(), 0);
    CAPTURE(name);
    CHECK(unknowns == all);
    CHECK(equations == all);
  }
}

TEST_CASE("a step without an instruction is refused with what it is met by") {
  RandomNumbers random(45);
  const Answer answer = by_plan(sketched(random_platform(3, random), random));
  CHECK(answer.status == RunStatus::unsupported);
  CHECK(answer.reason ==
        "no instruction places the body 'b1', which is met by: distance 'p0', distance 'p1', distance 'p2', "
        "distance 'p3', distance 'p4', distance 'p5'");
}
