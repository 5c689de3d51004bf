/// The stiff and extreme families: that they are what they say, that their references hold all solutions, and
/// how strategies fare.

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "harness/instances/families.hpp"
#include "harness/instances/family_lists.hpp"
#include "harness/results/accuracy.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tables/table_run.hpp"
#include "harness/tables/tables.hpp"

using namespace gcs;

namespace {

struct NoMonitor final : Monitor {
  void progress(std::string_view, double) override {}
};

ReferenceList reference_of(const std::string& id) {
  const Instance instance = load_member(id);
  NoMonitor monitor;
  return reference_for(instance, Scene(instance.problem), 60, monitor);
}

std::size_t real_solutions(const ReferenceList& list) {
  return static_cast<std::size_t>(std::count_if(list.solutions.begin(), list.solutions.end(),
                                                [](const KnownSolution& s) { return s.figure.is_real(); }));
}

RunFile measured(const std::vector<std::string>& members, const std::vector<std::string>& strategies = {}) {
  TableRequest request;
  request.strategies = strategies;
  request.tables = {"stability"};
  request.instances = members;
  request.repetitions = 1;
  NoMonitor monitor;
  return run_tables(request, {}, monitor);
}

void check_right(const CellRecord& cell) {
  INFO(cell.spec.instance << ", " << cell.spec.strategy << ": " << cell.reason << cell.difference);
  CHECK(cell.is_right());
  REQUIRE(cell.accuracy);
  CHECK(cell.accuracy->missed.value_or(0) == 0);  // of a path nothing is known
  CHECK(cell.accuracy->spurious == 0);
  CHECK(cell.accuracy->largest_quotient <= 10);
}

/// Who may say that it has not all, with the reason: half angles of points at infinity are finite, and look like
/// those of points far away.
bool may_be_partial(const CellRecord& cell) {
  return cell.status == RunStatus::partial && !cell.reason.empty() && !cell.is_flawed() &&
         cell.spec.strategy == "system-paths";
}

void check_right(const RunFile& run) {
  for (const CellRecord& cell : run.cells)
    if (cell.status != RunStatus::unsupported && !cell.is_search_in_vain() && !may_be_partial(cell))
      check_right(cell);
}

/// No strategy calls its answer complete, and each says why. Some would search for long.
void check_ill_posed(const std::string& id) {
  const Scene scene(load_member(id).problem);
  RunLimits limits;
  limits.time_limit_s = 1;
  for (const StrategyEntry& entry : all_strategies()) {
    const SolveRun run = run_strategy(entry, {}, scene, limits);
    INFO(id << ", " << entry.name << ": " << word(run.status) << " " << run.reason);
    CHECK(run.status != RunStatus::complete);
    CHECK_FALSE(run.reason.empty());
  }
}

/// Every strategy that can do a family's tame member does it right.
void check_tame_members(std::span<const InstanceFamily> families) {
  for (const InstanceFamily& family : families) {
    const std::string tame = family.members().front();
    is_ill_posed(tame) ? check_ill_posed(tame) : check_right(measured({tame}));
  }
}

}  // namespace

TEST_CASE("every member of every family is an instance") {
  std::set<std::string> ids;
  for (const InstanceFamily& family : families()) {
    CHECK(find_family(family.name) == &family);
    for (const std::string& id : family.members()) {
      INFO(id);
      CHECK(ids.insert(id).second);
      CHECK(load_member(id).id == id);
    }
  }
}

TEST_CASE("every strategy is right on the tame members of flat families") {
  check_tame_members(flat_families());
}

TEST_CASE("every strategy is right on the tame members of families with a line") {
  check_tame_members(line_families());
}

TEST_CASE("every strategy is right on the tame members of octahedra") {
  check_tame_members(octahedron_families());
}

TEST_CASE("every strategy is right on the tame members of compound families, or says why not") {
  check_tame_members(compound_families());
}

TEST_CASE("a search finds nothing in vain where nothing exists by proof, and gives up anywhere else") {
  for (const auto& [id, exists] : {std::pair("infeasible@1e-4", false), {"flat-triangle@1e-4", true}}) {
    INFO(id);
    const Scene scene(load_member(id).problem);
    const AccuracyJudge judge(scene, reference_of(id));
    SolveRun run;
    run.status = RunStatus::gave_up;
    for (const Claim claim : {Claim::some_real, Claim::all_real_of_component}) {
      run.claim = claim;
      CHECK(judge.is_search_in_vain(run) == !exists);
    }
    run.claim = Claim::on_path;
    CHECK_FALSE(judge.is_search_in_vain(run));
  }
  const RunFile run = measured({"infeasible@1e-4", "infeasible@1e-15", "collinear-centres@1e-10"},
                               {"newton-multistart", "explore"});
  for (const CellRecord& cell : run.cells) CHECK(cell.is_search_in_vain());
}

TEST_CASE("infinitely many solutions are found where there are, and nowhere else") {
  RunLimits limits;
  limits.time_limit_s = 1;
  int found = 0;
  for (const std::string id : {"bricard@0", "bricard-two@0", "bricard@0.5", "bricard-two@1e-8"}) {
    const Scene scene(load_member(id).problem);
    for (const StrategyEntry& entry : all_strategies()) {
      if (run_strategy(entry, {}, scene, limits).status != RunStatus::infinite) continue;
      INFO(id << ", " << entry.name);
      CHECK(is_ill_posed(id));
      ++found;
    }
  }
  CHECK(found >= 2);
}

TEST_CASE("an answer that the time limit cuts short says so, and not what was left to look into") {
  const Scene scene(load_member("bricard@1e-15").problem);  // whose ends take seconds in more and more bits
  RunLimits limits;
  limits.time_limit_s = 1;
  for (const char* strategy : {"monodromy", "polyhedral"}) {
    const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, limits);
    INFO(word(run.status) << " " << run.reason);
    CHECK((run.status == RunStatus::timed_out || run.status == RunStatus::complete));
  }
}

TEST_CASE("scenes scaled by a power of two have exactly scaled lengths") {
  const ProblemStatement tame = load_member("scale-of-two@0").problem;
  for (const int exponent : {100, -100, 1000, -1000}) {
    const ProblemStatement scaled = load_member("scale-of-two@" + std::to_string(exponent)).problem;
    for (std::size_t e = 0; e < tame.constraints.size(); ++e)
      CHECK(scaled.constraints[e].given.value == std::ldexp(tame.constraints[e].given.value, exponent));
    CHECK(scaled.interpolation.bend == std::ldexp(tame.interpolation.bend, exponent));
  }
}

TEST_CASE("the path of a near miss is flat half-way but for the parameter") {
  for (const auto& [value, epsilon] : {std::pair{"0.5", 0.5}, {"1e-4", 1e-4}, {"1e-12", 1e-12}}) {
    const Scene scene(load_member(std::string("near-miss@") + value).problem);
    const std::vector<LengthPath>& lengths = scene.length_paths();
    const double gap = lengths[1].value(0.5) + lengths[2].value(0.5) - lengths[0].value(0.5);
    CHECK(std::ldexp(gap, scene.unit_exponent()) == Approx(epsilon).epsilon(1e-3));
  }
}

TEST_CASE("references hold the solutions that doubles do not tell apart") {
  for (const std::string value : {"1e-4", "1e-8", "1e-15"}) {
    INFO(value);
    // The third point above or below the line of the first two, and the fourth beside it: two classes.
    const ReferenceList flat = reference_of("flat-triangle@" + value);
    CHECK(flat.has_all_complex);
    CHECK(real_solutions(flat) == 2);
    // Here these are complex.
    const ReferenceList infeasible = reference_of("infeasible@" + value);
    CHECK(infeasible.has_all_complex);
    CHECK(infeasible.solutions.size() == 2);
    CHECK(real_solutions(infeasible) == 0);
    // K3,3 has 8 classes.
    CHECK(reference_of("double-root@" + value).solutions.size() == 8);
  }
}

TEST_CASE("references of compound scenes hold as many solutions as theory counts") {
  for (const std::string value : {"0.5", "1e-4"}) {
    INFO(value);
    // K3,3 has 8 classes, and each of two points hangs on either side.
    CHECK(reference_of("mixed-lengths@" + value).solutions.size() == 32);
  }
  for (const std::string value : {"0.25", "1e-2"}) {
    INFO(value);
    // Three points on either side of what they hang on, up to reflection. Only points 1 to 3 apart carry the
    // last.
    const ReferenceList list = reference_of("inconsistent@" + value);
    CHECK(list.solutions.size() == 4);
    CHECK(real_solutions(list) == 0);
  }
}

TEST_CASE("references are known to hold all where the others are proven to be at infinity") {
  for (const std::string id : {"bricard@1e-2", "bricard-two@1e-4"}) {
    INFO(id);
    const ReferenceList list = reference_of(id);
    CHECK(list.has_all_complex);
    CHECK(list.solutions.size() < 8);  // of an octahedron at generic lengths
    // Elimination knows nothing of paths and their ends.
    const SolveRun eliminated =
        run_strategy(find_strategy("cayley-menger"), {}, Scene(load_member(id).problem), {});
    CHECK(eliminated.status == RunStatus::complete);
    CHECK(list.solutions.size() == eliminated.solutions.size());
  }
}

TEST_CASE("beside an extremum of the open side the condition number grows like that of a double root") {
  const auto largest_condition = [](const std::string& id) {
    const Scene scene(load_member(id).problem);
    const SolveRun run = run_strategy(find_strategy("theta-scan"), {}, scene, {});
    double largest = 0;
    for (const AssessedSolution& solution : run.solutions) largest = std::max(largest, solution.condition);
    return largest;
  };
  const double ratio = largest_condition("open-side@1e-10") / largest_condition("open-side@1e-6");
  CHECK(ratio == Approx(100).epsilon(0.02));
}

TEST_CASE("the path of a long detour is as long as it says") {
  const Scene scene(load_member("long-detour@1e3").problem);
  const StrategyEntry& entry = find_strategy("full-space");
  const SolveReport report = entry.make(complete_options(entry, {}))->solve(scene);
  REQUIRE(report.paths.size() == 1);
  CHECK(report.paths.front().end == PathRecord::End::closed);
  CHECK(report.paths.front().length > 1e3);
}

TEST_CASE("two solutions near a fold are two") {
  // Both real, at a condition number of 1e8.
  const Scene scene(load_member("double-root@1e-6").problem);
  const SolveRun run = run_strategy(find_strategy("plan-scan"), {}, scene, {});
  CHECK(run.counts.real_up_to_reflection == 2u);
}

TEST_CASE("two solutions whose paths are not told apart are not called a double one") {
  for (const std::string id : {"flat-triangle@1e-6", "double-root@1e-4", "mixed-lengths@1e-10"}) {
    const Scene scene(load_member(id).problem);
    const SolveRun run = run_strategy(find_strategy("monodromy"), {}, scene, {});
    INFO(id << ": " << run.reason);
    const bool tells_them_apart = run.counts.singular == 0u;
    CHECK((tells_them_apart || run.status == RunStatus::partial));
  }
}

TEST_CASE("paths to solutions next to each other are told apart by small circles") {
  // K3,3 has 8 classes, and two points that hang on it quadruple them.
  for (const auto& [id, classes] : {std::pair{"double-root@1e-4", 8u}, {"mixed-lengths@1e-4", 32u}}) {
    const Scene scene(load_member(id).problem);
    const SolveRun run = run_strategy(find_strategy("monodromy"), {}, scene, {});
    INFO(id << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.solutions.size() == classes);
  }
}

TEST_CASE("paths that end on a curve of solutions are said to") {
  // Generic paths to an octahedron that moves end anywhere on its curve, and not at conjugates of each other.
  const Scene scene(load_member("bricard@0").problem);
  const SolveRun run = run_strategy(find_strategy("monodromy"), {}, scene, {});
  CHECK(run.status == RunStatus::partial);
  CHECK_THAT(run.reason, Catch::Contains("not isolated"));
}

TEST_CASE("errors of stiff members are explained by the condition of the solutions") {
  check_right(
      measured({"near-miss@1e-8", "coplanar-centres@1e-8", "cyclohexane@1e-8", "flat-tetrahedron@1e-4",
                "short-edge@1e-2", "scale-of-ten@100", "scale-of-two@-500"}));
}

TEST_CASE("a scan tells apart solutions that the lengths as doubles do not") {
  check_right(measured({"double-root@1e-8", "double-root@1e-10", "double-root@1e-12", "flat-triangle@1e-8",
                        "flat-triangle@1e-12", "flat-tetrahedron@1e-8", "short-edge@1e-6", "short-edge@1e-8"},
                       {"plan-scan"}));
}

TEST_CASE("boxes tell apart solutions that are closer together than boxes become") {
  check_right(measured({"double-root@1e-10", "double-root@1e-12", "flat-triangle@1e-12",
                        "flat-tetrahedron@1e-12", "inconsistent@1e-12"},
                       {"box-subdivision"}));
}

TEST_CASE("errors of members that move, escape or mix lengths are explained by the condition, too") {
  check_right(measured({"bricard@1e-2", "bricard-two@1e-2", "escaping@1e-4", "mixed-lengths@1e-4",
                        "inconsistent@1e-1", "long-detour@1e3"}));
}

/// As many as are proven on S where the member is tame: S is the same curve but for a small change.
TEST_CASE("solutions next to a fold of S are met, and none are where S falls short of t = 1") {
  const auto on_path = [](const std::string& id, const std::string& strategy, const OptionMap& options) {
    const Scene scene(load_member(id).problem);
    const SolveRun run = run_strategy(find_strategy(strategy), options, scene, {});
    INFO(id << ", " << strategy << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.failed_checks.empty());
    return run.counts.on_path;
  };
  for (const std::string family : {"flat-triangle", "double-root", "infeasible"}) {
    const auto expected = on_path(family + "@1e-2", "full-space", {{"mode", "certified"}});
    for (const std::string value : {"1e-6", "1e-8", "1e-10", "1e-12"})
      for (const std::string strategy : {"full-space", "rcp"})
        CHECK(on_path(family + "@" + value, strategy, {}) == expected);
  }
  for (const std::string strategy : {"full-space", "rcp"}) {
    const Scene scene(load_member("double-root@1e-15").problem);
    const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, {});
    CHECK(run.status == RunStatus::partial);
    CHECK_THAT(run.reason, Catch::Contains("touching t = 1"));
  }
}

TEST_CASE("solutions next to a fold are found from random starts, and on curves that begin there") {
  check_right(measured({"flat-triangle@1e-8", "flat-triangle@1e-12", "flat-tetrahedron@1e-10",
                        "double-root@1e-12", "parallel-lines@1e-10", "straight-segments@1e-10"},
                       {"newton-multistart", "explore"}));
}

TEST_CASE("next to a fold S crosses t = 1 twice, whichever way and in whatever steps it is followed") {
  const std::vector<OptionMap> settings{
      {}, {{"orientation", "backward"}}, {{"tolerance", "5e-8"}}, {{"order", "14"}}};
  for (const std::string value : {"1e-6", "1e-8", "1e-10"})
    for (const std::string strategy : {"full-space", "rcp"})
      for (const OptionMap& options : settings) {
        const Scene scene(load_member("flat-triangle@" + value).problem);
        const SolveRun run = run_strategy(find_strategy(strategy), options, scene, {});
        INFO(value << ", " << strategy << (options.empty() ? "" : ", " + options.begin()->first));
        CHECK(run.status == RunStatus::complete);
        CHECK(run.crossings.size() == 4);
        CHECK(run.counts.on_path == 2u);
      }
}

TEST_CASE("two solutions between which a path ends are found from there") {
  const std::vector<std::string> close{"flat-triangle@1e-6", "flat-tetrahedron@1e-6", "double-root@1e-4"};
  check_right(measured(close, {"monodromy", "polyhedral"}));
  // Beside the paths, which meet two real ones there.
  for (const std::string id : {"flat-triangle@1e-8", "double-root@1e-8"})
    check_right(measured({id}, {"full-space", "plan-scan", "monodromy", "polyhedral"}));
  // So near that their places rounded to doubles are proven to be real in the reals alone.
  check_right(measured({"double-root@1e-12"}, {"monodromy", "polyhedral"}));
}

TEST_CASE("solutions too far away for the distances of doubles are found, and proven to be there") {
  check_right(measured({"escaping@1e-8", "escaping@1e-12", "inconsistent@1e-8", "inconsistent@1e-12",
                        "short-edge@1e-8", "short-edge@1e-10"},
                       {"monodromy", "polyhedral"}));
  for (const std::string id :
       {"escaping@1e-12", "inconsistent@1e-12", "short-edge@1e-6", "short-edge@1e-12"}) {
    const Scene scene(load_member(id).problem);
    const SolveRun run = run_strategy(find_strategy("monodromy"), {}, scene, {});
    INFO(id << ": " << run.reason);
    CHECK(run.counts.at_infinity.value_or(0) == 0u);
    // Also those next to which the short edge is none, in doubles. By exact elimination 4 of the 8 are real.
    CHECK(run.status == RunStatus::complete);
    if (id.starts_with("short-edge")) CHECK(run.solutions.size() == 8u);
    if (id.starts_with("short-edge")) CHECK(run.counts.real_up_to_reflection == 4u);
  }
}

TEST_CASE("solutions next to each other are listed, or the answer is partial") {
  check_right(measured({"mixed-lengths@1e-12"}, {"plan-scan", "box-subdivision", "monodromy", "polyhedral"}));
  check_right(measured({"straight-segments@1e-8", "straight-segments@1e-10", "parallel-planes@1e-8",
                        "parallel-planes@1e-10", "opposite-planes@1e-8", "opposite-planes@1e-10"},
                       {"plan-scan"}));
  // Two lines at right angles but for 1e-15 on either side: the same doubles.
  const Scene scene(load_member("right-angle@1e-15").problem);
  const SolveRun run = run_strategy(find_strategy("plan-scan"), {}, scene, {});
  CHECK(run.status == RunStatus::partial);
  CHECK_THAT(run.reason, Catch::Contains("doubles do not tell all apart"));
}

TEST_CASE("tangents are right where doubles do not hold their distances") {
  check_right(measured({"collinear-centres@1e-4", "collinear-centres@1e-8", "collinear-centres@1e-15"},
                       {"sphere-tangents", "monodromy", "polyhedral"}));
}

TEST_CASE("determinants find the solutions whose coordinates are 1e6 to 1e12 times the lengths") {
  check_right(measured({"short-edge@1e-6", "short-edge@1e-8", "short-edge@1e-12", "escaping@1e-6",
                        "escaping@1e-8", "escaping@1e-12"},
                       {"cayley-menger"}));
}

TEST_CASE("octahedra that all but move are solved") {
  check_right(measured({"bricard-two@1e-8"}, {"full-space", "rcp", "monodromy", "polyhedral"}));
  // Four pairs of diagonals are at infinity. Two and four of the others are real, by paths in balls and by exact elimination.
  const auto check_counts = [](const std::string& id, const std::string& strategy, std::uint64_t real,
                               std::uint64_t seed = 1) {
    const Scene scene(load_member(id).problem);
    RunLimits limits;
    limits.seed = seed;
    const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, limits);
    INFO(id << ", " << strategy << ", seed " << seed << ": " << run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.at_infinity == 4u);
    CHECK(run.solutions.size() == 4u);
    CHECK(run.counts.real_up_to_reflection == real);
  };
  check_counts("bricard-two@1e-10", "monodromy", 4);
  check_counts("bricard@1e-12", "cayley-menger", 2);
  check_counts("bricard-two@1e-12", "cayley-menger", 4);
  check_counts("bricard@1e-15", "cayley-menger", 2);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) check_counts("bricard@1e-15", "polyhedral", 2, seed);
}

// Corrections stall where rounding of residuals is amplified; crossings drown where t hardly changes.
TEST_CASE("paths are followed where arcs all but meet, and decided where they are all but flat") {
  check_right(
      measured({"near-miss@1e-12", "bricard@1e-10", "bricard-two@1e-10"}, {"full-space", "rcp", "explore"}));
  // Next to the target S turns within 1e-10.
  check_right(measured({"short-edge@1e-10"}, {"full-space", "rcp"}));
  // Crossings are refined in double-double.
  check_right(measured({"bricard@1e-12", "bricard-two@1e-12"}, {"rcp"}));
}

TEST_CASE("errors are below the condition number times half of the unit roundoff") {
  const RunFile run = measured(
      {"touching-spheres@0.5", "touching-spheres@1e-8", "straight-bodies@1e-1", "symmetric-body@1e-2"},
      {"newton-multistart", "monodromy"});
  for (const CellRecord& cell : run.cells) {
    INFO(cell.spec.instance << ", " << cell.spec.strategy);
    REQUIRE(cell.accuracy);
    CHECK(cell.accuracy->largest_quotient <= 0.5);
  }
}

// Out and back in steps that grow with the distance: a thousand times as far takes a few times as many.
TEST_CASE("a detour costs steps like the logarithm of its length") {
  check_right(measured({"long-detour@1e6"}, {"full-space", "rcp"}));
  for (const std::string strategy : {"full-space", "rcp"}) {
    const auto steps = [&](const std::string& id) {
      const Scene scene(load_member(id).problem);
      return run_strategy(find_strategy(strategy), {}, scene, {}).work.iterations;
    };
    INFO(strategy);
    CHECK(steps("long-detour@1e6") < 4 * steps("long-detour@1e3"));
  }
}

TEST_CASE("some solutions that doubles do not tell apart are listed as one") {
  // 8 of K3,3 with two points on either side, 1e-12 apart.
  const Scene scene(load_member("mixed-lengths@1e-12").problem);
  const SolveRun run = run_strategy(find_strategy("newton-multistart"), {}, scene, {});
  CHECK(run.status == RunStatus::complete);
  CHECK(run.failed_checks.empty());
  CHECK(run.solutions.size() == 2);  // both real classes of K3,3
}

TEST_CASE("why not all solutions of a product are listed is said") {
  const auto reason = [](const std::string& strategy, const std::string& member, const RunLimits& limits) {
    const SolveRun run =
        run_strategy(find_strategy(strategy), {}, Scene(load_member(member).problem), limits);
    CHECK(run.failed_checks.empty());
    return run.reason;
  };
  CHECK(reason("plan-scan", "mixed-lengths@1e-15", {}) ==
        "2 of the 8 solutions are listed; doubles do not tell all apart");
  CHECK(reason("monodromy", "mixed-lengths@1e-15", {}) ==
        "8 of the 32 solutions are listed; doubles do not tell all apart");
  CHECK(reason("plan-scan", "mixed-lengths@1e-4", {{.max_solutions = 5}}) ==
        "5 of the 8 solutions are listed; max_solutions lists more");
}

TEST_CASE("an edge of length 1e-8 refuses no path strategy") {
  check_right(measured({"short-edge@1e-6", "short-edge@1e-8"}, {"full-space", "rcp"}));
}

TEST_CASE("solutions on S that are as near as an edge of length 1e-8 is short are told apart") {
  for (const std::string value : {"1e-6", "1e-8"})
    for (const std::string strategy : {"full-space", "rcp"}) {
      const Scene scene(load_member("short-edge@" + value).problem);
      const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, {});
      INFO(value << ", " << strategy);
      CHECK(run.status == RunStatus::complete);
      CHECK(run.counts.on_path == 4u);
    }
}

TEST_CASE("a crossing that is no solution is not part of a complete answer") {
  for (const std::string strategy : {"full-space", "rcp"}) {
    const Scene scene(load_member("short-edge@1e-12").problem);
    const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, {});
    INFO(strategy << ": " << run.reason);
    CHECK((run.status != RunStatus::complete || run.failed_checks.empty()));
  }
}

TEST_CASE("tangents that are close together are told apart") {
  check_right(measured({"touching-spheres@1e-8", "touching-spheres@1e-10"}, {"sphere-tangents"}));
}

TEST_CASE("what is shown of a stored run is what is shown of the run") {
  const RunFile run = measured(find_family("near-miss")->members());
  const RunFile stored = parse_run_file(to_json_text(run), "run.json");
  const TableSet set = build_tables(stored, {});
  REQUIRE(set.tables.size() == 2);
  CHECK(set.tables[0].name == "stability-near-miss");
  CHECK(set.tables[1].name == "stability-refusals");
  REQUIRE(set.drawings.size() == 1);
  CHECK(set.drawings.front().svg == draw_stability(run).front().svg);
}
