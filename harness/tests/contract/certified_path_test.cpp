/// The proven path against the one that is only followed, on the shipped instances.

#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/interface/strategy_interface.hpp"

using namespace gcs;

namespace {

/// From so many constraints on, once around is enough.
constexpr int long_path = 30;

SolveReport solved(const Scene& scene, const OptionMap& options) {
  for (const StrategyEntry& entry : all_strategies())
    if (entry.name == "full-space") return entry.make(complete_options(entry, options))->solve(scene);
  FAIL("no full-space");
  return {};
}

/// Both met the same points in the same order and directions.
void check_same_crossings(const SolveReport& a, const SolveReport& b, double size) {
  REQUIRE(a.paths.size() == 1);
  REQUIRE(b.paths.size() == 1);
  const std::vector<Crossing>&of_a = a.paths[0].crossings, of_b = b.paths[0].crossings;
  REQUIRE(of_a.size() == of_b.size());
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    CAPTURE(i);
    CHECK(of_a[i].direction == of_b[i].direction);
    const Figure &here = a.candidates[static_cast<std::size_t>(of_a[i].candidate)].figure,
                 &there = b.candidates[static_cast<std::size_t>(of_b[i].candidate)].figure;
    CHECK((here.points - there.points).norm() <= 1e-9 * size);
  }
  CHECK(a.paths[0].length == Approx(b.paths[0].length).epsilon(1e-4));
}

}  // namespace

TEST_CASE("the proven path is the one that the fast tracker follows") {
  int proven = 0;
  for (const std::string& id : shipped_instances()) {
    const Scene scene(load_instance(id).problem);
    if (!scene.sketch() || scene.has_lines() || scene.problem().is_general()) continue;
    for (const std::string orientation : {"forward", "backward"}) {
      if (scene.constraint_count() >= long_path && orientation == "backward") continue;
      INFO(id << " " << orientation);
      const SolveReport report = solved(scene, {{"mode", "certified"}, {"orientation", orientation}});
      CHECK(report.reason.empty());
      REQUIRE(report.paths.size() == 1);
      CHECK(report.paths[0].end == PathRecord::End::closed);
      CHECK(report.paths[0].proven);
      check_same_crossings(report, solved(scene, {{"orientation", orientation}}), scene.size());
      proven += report.paths[0].proven ? 1 : 0;
    }
  }
  CHECK(proven >= 10);
}

TEST_CASE("the proof depends on no setting of the tracker") {
  const Scene scene(load_instance("disulfide").problem);
  const SolveReport report = solved(scene, {{"mode", "certified"}});
  for (const OptionMap& options :
       {OptionMap{{"order", "5"}}, OptionMap{{"order", "20"}}, OptionMap{{"tolerance", "1e-5"}},
        OptionMap{{"tolerance", "1e-12"}}, OptionMap{{"step_max", "0.05"}}}) {
    OptionMap all = options;
    all["mode"] = "certified";
    const SolveReport other = solved(scene, all);
    INFO(other.reason);
    CHECK(other.paths[0].proven);
    check_same_crossings(report, other, scene.size());
  }
}

TEST_CASE("rcp refuses mode=certified with a reason") {
  for (const StrategyEntry& entry : all_strategies())
    if (entry.name == "rcp")
      CHECK_THROWS_WITH(entry.make(complete_options(entry, {{"mode", "certified"}})),
                        Catch::Contains("only full-space has it"));
}

TEST_CASE("the jumps of the published tracker are named") {
  const Scene scene(load_instance("icosahedron").problem);
  const SolveReport proven = solved(scene, {{"mode", "certified"}});
  const SolveReport jumped = solved(scene, {{"mode", "paper"}, {"step_max", "0.1"}, {"jumps", "named"}});
  CHECK(proven.paths[0].proven);
  CHECK_FALSE(jumped.paths[0].proven);
  CHECK(jumped.paths[0].end == PathRecord::End::closed);
  CHECK(jumped.paths[0].crossings.size() > proven.paths[0].crossings.size());
  CHECK(jumped.status == SolveStatus::partial);
  REQUIRE(jumped.particulars.size() == 1);
  CHECK(jumped.particulars[0].name == "jumps");
  // Once away, and once back, or it would not have closed.
  CHECK(jumped.particulars[0].value >= 2);
  CHECK_THAT(jumped.reason,
             Catch::Contains("to a curve that is not S") && Catch::Contains("from a curve that is not S"));
}

TEST_CASE("a tracker that keeps to the path has no jumps to name") {
  for (const std::string id : {"octahedron", "dodecagon", "k33"}) {
    const Scene scene(load_instance(id).problem);
    const SolveReport report = solved(scene, {{"mode", "paper"}, {"jumps", "named"}});
    INFO(id << ": " << report.reason);
    CHECK(report.status == SolveStatus::complete);
    CHECK(report.particulars == std::vector<Particular>{{"jumps", 0}});
  }
}
