/// The default mode of the path strategies never jumps: the solutions on S do not depend on the bound of the
/// steps, nor on the strategy. scripts/sweep-step-bound does the same on many more scenes.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "harness/instances/instance_lookup.hpp"
#include "harness/sweeps/random_scenes.hpp"
#include "harness/sweeps/step_bound_check.hpp"
#include "solvers/model/scene.hpp"

using namespace gcs;

namespace {

constexpr std::uint64_t random_scenes = 30;

/// Returns how many solutions there are on S.
std::size_t check_agreement(const std::string& name, const Scene& scene, std::span<const StepBound> bounds) {
  const StepBoundVerdict verdict = check_step_bounds(scene, bounds);
  INFO(name << ":\n" << verdict.explanation());
  CHECK(verdict.runs.size() == 2 * bounds.size());
  CHECK(verdict.unfinished.empty());
  CHECK(verdict.differences.empty());
  return verdict.solutions;
}

/// An icosahedron's S is long: one smaller bound has to do.
bool is_long(const std::string& instance) { return instance.starts_with("icosahedron"); }

}  // namespace

TEST_CASE("smaller steps and the other strategy find the same solutions on random scenes") {
  int scenes_with_solutions = 0;
  for (std::uint64_t seed = 1; seed <= random_scenes; ++seed) {
    const Scene scene(random_problem(random_scene_kind(seed), seed));
    if (check_agreement("seed " + std::to_string(seed), scene, default_step_bounds()) > 0)
      ++scenes_with_solutions;
  }
  CHECK(scenes_with_solutions >= 10);
}

TEST_CASE("smaller steps and the other strategy find the same solutions on the shipped instances") {
  int checked = 0;
  for (const std::string& id : shipped_instances()) {
    const ProblemStatement problem = load_instance(id).problem;
    if (!problem.sketch || problem.is_general() || !problem.lines.empty()) continue;  // rcp places points
    std::vector<StepBound> bounds = default_step_bounds();
    if (is_long(id)) bounds.resize(2);
    CHECK(check_agreement(id, Scene(problem), bounds) > 0);
    ++checked;
  }
  CHECK(checked >= 6);
}

TEST_CASE("a tracker that jumps is noticed") {
  const Scene scene(load_instance("disulfide").problem);
  const std::vector<StepBound> bounds{{"default", {}}, {"leaps", {{"mode", "paper"}, {"step_max", "1"}}}};
  const StepBoundVerdict verdict = check_step_bounds(scene, bounds);
  CHECK_THAT(verdict.explanation(), Catch::Contains("full-space (leaps) differs from full-space (default)") &&
                                        Catch::Contains("2 solutions missing"));
}

TEST_CASE("a run that does not end is reported with its reason") {
  const Scene scene(load_instance("k33").problem);
  const std::vector<StepBound> bounds{{"short", {{"max_steps", "3"}}}};
  const StepBoundVerdict verdict = check_step_bounds(scene, bounds);
  CHECK(verdict.unfinished.size() == 2);
  CHECK_FALSE(verdict.agrees());
  CHECK_THAT(verdict.explanation(), Catch::Contains("max_steps reached"));
}

TEST_CASE("a seed gives one problem, and few points hang on exactly d others") {
  int points = 0;
  int hanging = 0;
  for (std::uint64_t seed = 1; seed <= 70; ++seed) {
    const ProblemStatement problem = random_problem(random_scene_kind(seed), seed);
    const ProblemStatement again = random_problem(random_scene_kind(seed), seed);
    CHECK(problem.sketch->points == again.sketch->points);
    std::vector<int> degree(problem.points.size(), 0);
    for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
      CHECK(problem.constraints[i].between == again.constraints[i].between);
      CHECK(problem.constraints[i].given.text == again.constraints[i].given.text);
      for (const int end : problem.constraints[i].between) ++degree[end];
    }
    points += static_cast<int>(degree.size());
    hanging += static_cast<int>(std::count(degree.begin(), degree.end(), problem.dimension));
  }
  CHECK(3 * hanging < points);
}
