#include "harness/tests/contract/count_limits.hpp"

#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/sweeps/random_scenes.hpp"
#include "harness/tests/contract/spoiled_strategy.hpp"

using namespace gcs;
using namespace gcs::contract;

namespace {

/// Five more than 4: the octahedron has 8 classes.
void invent_solutions(SolveReport& report, const Circumstances&) {
  for (int i = 1; i <= 5; ++i) {
    report.candidates.push_back(report.candidates[0]);
    report.candidates.back().figure.points(0, 3) += 0.1 * i;
  }
}

/// What a subdivision that gives up has found by then must be within the limits too.
OptionMap options_for(const StrategyEntry& entry) {
  return entry.name == "box-subdivision" ? OptionMap{{"max_boxes", "5000"}} : OptionMap{};
}

}  // namespace

TEST_CASE("more solutions than there can be are caught by the limit") {
  const Scene scene(load_instance("octahedron").problem);
  const TheoreticalCounts counts = theoretical_counts(scene.problem());
  CHECK(check_limits(scene, counts, solve_anew({sound_strategy()}, scene)).empty());
  const Violations found = check_limits(scene, counts, solve_anew({spoiled<invent_solutions>()}, scene));
  REQUIRE(found.size() == 1);
  CHECK(found[0].check == "limit");
}

TEST_CASE("no strategy finds more on random graphs than there can be") {
  std::size_t solutions = 0;
  constexpr std::uint64_t scenes = 4 * scene_kind_count;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const ProblemStatement problem = random_problem(random_scene_kind(seed), seed);
    const Scene scene(problem);
    const TheoreticalCounts counts = theoretical_counts(problem);
    for (const StrategyEntry& entry : all_strategies()) {
      if (!supports({entry}, scene)) continue;
      const SolveReport report = solve_anew({entry, options_for(entry)}, scene);
      INFO(entry.name << " on random graph " << seed << "\n"
                      << in_words(check_limits(scene, counts, report)));
      CHECK(check_limits(scene, counts, report).empty());
      solutions += report.candidates.size();
    }
  }
  CHECK(solutions > 0);
}
