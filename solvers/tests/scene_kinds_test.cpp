/// Every strategy solves one small scene of every kind that it supports, proven and in more digits. What is compared
/// elsewhere with the literature is here run once on several threads, for the sanitizers.
#include <catch2/catch.hpp>
#include <gcsbench/gcsbench.hpp>
#include <map>

#include "solvers/tests/grown_graphs.hpp"

namespace gcs {
namespace {

Instance shipped(const std::string& id) {
  return read_instance(GCSBENCH_SOURCE_DIR "/instances/" + id + ".json");
}

/// A point hung on a triangle that is hung on another: nothing is left to solve when all is taken apart.
Problem hung_points() {
  Problem problem(2);
  problem.points("a", "b", "c", "d", "e").distance("a", "b", 4).distance("b", "c", 5).distance("c", "a", 6);
  problem.distance("d", "a", 4).distance("d", "b", 5).distance("e", "d", 6).distance("e", "c", 5);
  problem.sketch("a", {0, 0})
      .sketch("b", {4, 0})
      .sketch("c", {"3.4", 5})
      .sketch("d", {"0.9", "-3.9"})
      .sketch("e", {"3.5", 1});
  return problem;
}

Problem given_positions() {
  Problem problem(3);
  problem.points("a", "b", "c", "d").fix("a", {0, 0, 0}).fix("b", {2, 0, 0}).fix("c", {0, 2, 0});
  problem.distance("d", "a", "1.5").distance("d", "b", "1.7").distance("d", "c", "1.9");
  problem.sketch("a", {0, 0, 0}).sketch("b", {2, 0, 0}).sketch("c", {0, 2, 0}).sketch("d", {1, 1, 1});
  return problem;
}

std::map<std::string, Scene> kinds_of_scenes() {
  samples::RandomNumbers random(3);
  return {{"points in the plane", shipped("k33")},
          {"points in space", shipped("octahedron")},
          {"an octahedron with a ring", shipped("octahedron-cyclohexane")},
          {"points and a line", shipped("hoffmann-yuan")},
          {"a line and given points", shipped("tangents-equal-radii")},
          {"hung points", hung_points()},
          {"rigid parts", Scene(samples::placed_at_random(samples::chain_of_octahedra(2), random))},
          {"given positions", given_positions()}};
}

/// The settings that lead through other code than the defaults.
std::vector<OptionMap> settings_of(const StrategyEntry& entry) {
  if (entry.name == "full-space") return {{}, {{"mode", "paper"}}, {{"mode", "certified"}}};
  if (entry.name == "rcp") return {{}, {{"mode", "paper"}}, {{"reduce", "on"}}};
  if (entry.name == "theta-scan" || entry.name == "plan-scan") return {{}, {{"method", "published"}}};
  if (entry.name == "sphere-tangents") return {{}, {{"method", "homotopy"}}, {{"method", "published"}}};
  if (entry.name == "monodromy") return {{}, {{"precision", "twice"}, {"instructions", "portable"}}};
  if (entry.name == "polyhedral") return {{}, {{"formulation", "coordinates"}}};
  if (entry.name == "newton-multistart") return {{{"starts", "20"}}};
  return {{}};
}

/// Of a line and five points, homotopies in twice the precision or in more unknowns take a minute.
bool is_long_way(const StrategyEntry& entry, const Scene& scene) {
  return scene.has_lines() && (entry.name == "monodromy" || entry.name == "polyhedral");
}

}  // namespace

TEST_CASE("every strategy solves a scene of every kind that it supports") {
  const std::map<std::string, Scene> scenes = kinds_of_scenes();
  std::map<std::string, int> solved;
  for (const StrategyEntry& entry : all_strategies())
    for (const OptionMap& given : settings_of(entry))
      for (const auto& [kind, scene] : scenes) {
        if (!given.empty() && is_long_way(entry, scene)) continue;
        const Answer answer = solve(scene, entry, given, {.threads = 2, .certify = true, .digits = 20});
        INFO(entry.name << ", " << kind << ": " << word(answer.status) << " " << answer.reason);
        if (answer.status == RunStatus::unsupported) continue;
        ++solved[kind];
        for (const FailedCheck& check : answer.failed_checks) FAIL_CHECK(check.what);
        CHECK((answer.status == RunStatus::complete || answer.status == RunStatus::partial));
        // From a sketch at random S may meet no solution.
        CHECK((!answer.solutions.empty() || (kind == "rigid parts" && entry.needs_sketch)));
      }
  CHECK(solved.size() == scenes.size());
}

}  // namespace gcs
