/// explore against published numbers of real solutions, against all complex ones, and the graph against what a walk along
/// closed curves must give.

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/sweeps/random_scenes.hpp"
#include "solvers/structure/decomposition.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const std::string& strategy, const OptionMap& options = {}) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

/// How often the curves without a value meet a solution.
std::map<std::pair<int, int>, int> meetings(const SolveRun& run) {
  std::map<std::pair<int, int>, int> result;
  for (const AssessedCurve& curve : run.curves)
    for (const AssessedCrossing& crossing : curve.crossings)
      ++result[{curve.released, crossing.solution.value()}];
  return result;
}

bool alternate(const std::vector<AssessedCrossing>& crossings) {
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (crossings[i].direction == crossings[(i + 1) % crossings.size()].direction) return false;
  return true;
}

std::int64_t real_solutions(const SolveRun& run) {
  return std::ranges::count_if(run.solutions, [](const AssessedSolution& one) { return one.is_real(); });
}

}  // namespace

TEST_CASE("exploring reaches all real solutions that are published, and they are proven to be different") {
  // Porta et al. 2007; Dietmaier 1998; Imbach, Mathis, Schreck 2016, table 1
  for (const auto& [id, published] : {std::pair{"disulfide", 18}, {"dietmaier", 40}, {"octahedron", 4}}) {
    const ProblemStatement problem = load_instance(id).problem;
    RunLimits limits;
    limits.certify = true;
    const SolveRun run = run_strategy(find_strategy("explore"), {}, Scene(problem), limits);
    CAPTURE(id, run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.claim == Claim::some_real);
    REQUIRE(run.proofs);
    CHECK(run.proofs->real == static_cast<std::uint64_t>(published));
    CHECK(run.failed_checks.empty());
  }
}

TEST_CASE(
    "where distances alone hold a scene every curve is closed and every solution is on one of each value") {
  const ProblemStatement problem = load_instance("disulfide").problem;
  const SolveRun run = solved(problem, "explore");
  const int values = static_cast<int>(problem.constraints.size());
  CHECK(std::ranges::all_of(run.curves, [](const AssessedCurve& curve) {
    return curve.end == PathRecord::End::closed && curve.crossings.size() % 2 == 0 &&
           alternate(curve.crossings);
  }));
  const auto met = meetings(run);
  CHECK(met.size() == run.solutions.size() * static_cast<std::size_t>(values));
  CHECK(std::ranges::all_of(met, [](const auto& entry) { return entry.second == 1; }));
}

TEST_CASE("beside given positions, and of several lines, every solution found is one of all") {
  // Four spheres with twelve real tangents: Macdonald, Pach, Theobald 2001. Two lines at four given points: 12 times 12.
  int explored = 0;
  for (const char* id : {"tangents-12-real", "two-lines"}) {
    const ProblemStatement problem = load_instance(id).problem;
    const SolveRun run = solved(problem, "explore", {{"reduce", "off"}}), all = solved(problem, "monodromy");
    CAPTURE(id, run.reason);
    CHECK(run.status == RunStatus::complete);
    CHECK_FALSE(run.curves.empty());
    CHECK(static_cast<std::int64_t>(run.solutions.size()) == real_solutions(all));
    explored += static_cast<int>(run.solutions.size());
  }
  CHECK(explored > 12);
}

TEST_CASE("exploring reaches as many real solutions of random scenes as there are among all complex ones") {
  int compared = 0;
  for (const SceneKind& kind : {SceneKind{2, 7}, SceneKind{3, 7}})
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const ProblemStatement problem = random_problem(kind, seed);
      if (decompose(problem, Split::all).size() > 1) continue;
      const SolveRun all = solved(problem, "monodromy");
      const SolveRun run = solved(problem, "explore");
      CAPTURE(kind.dimension, seed, run.reason, all.reason);
      REQUIRE(all.status == RunStatus::complete);
      CHECK(static_cast<std::int64_t>(run.solutions.size()) == real_solutions(all));
      ++compared;
    }
  CHECK(compared > 8);
}

TEST_CASE("curves of points and planes are proven, with the crossings that are found without a proof") {
  for (const char* id : {"octahedron", "octahedral-4p2h"}) {
    const ProblemStatement problem = load_instance(id).problem;
    const SolveRun fast = solved(problem, "explore");
    const SolveRun proven = solved(problem, "explore", {{"mode", "certified"}});
    CAPTURE(id, proven.reason);
    CHECK(proven.solutions.size() == fast.solutions.size());
    REQUIRE_FALSE(proven.curves.empty());
    CHECK(std::ranges::all_of(proven.curves, [](const AssessedCurve& curve) {
      return curve.proven && curve.crossings.size() % 2 == 0 && alternate(curve.crossings);
    }));
    CHECK(std::ranges::none_of(fast.curves, [](const AssessedCurve& curve) { return curve.proven; }));
    CHECK(proven.claim == Claim::all_real_of_component);
    CHECK(fast.claim == Claim::some_real);
    const SolveRun few = solved(problem, "explore", {{"mode", "certified"}, {"curves", "2"}});
    CHECK(few.claim == Claim::some_real);
    CHECK(meetings(proven).size() == meetings(fast).size());
  }
}

TEST_CASE("figures kept along curves meet every value but one, and the solutions at their places") {
  const ProblemStatement problem = load_instance("octahedron").problem;
  const SolveRun bare = solved(problem, "explore"), run = solved(problem, "explore", {{"samples", "3"}});
  CHECK(run.solutions.size() == bare.solutions.size());
  REQUIRE(run.curves.size() == bare.curves.size());
  const auto error = [&](const Figure& figure, const DistanceConstraint& c) {
    return std::abs((figure.points.col(c.between[0]) - figure.points.col(c.between[1])).norm() - c.length());
  };
  for (const AssessedCurve& curve : run.curves) {
    REQUIRE(curve.places.size() == curve.crossings.size());
    REQUIRE(curve.figures.size() > 3 * curve.crossings.size());
    double released = 0;
    for (const Figure& figure : curve.figures)
      for (std::size_t e = 0; e < problem.constraints.size(); ++e) {
        const double off = error(figure, problem.constraints[e]);
        if (static_cast<int>(e) != curve.released)
          CHECK(off < 1e-5);
        else
          released = std::max(released, off);
      }
    CHECK(released > 1e-3);
    for (const std::size_t place : curve.places)
      CHECK(error(curve.figures[place], problem.constraints[static_cast<std::size_t>(curve.released)]) <
            1e-5);
  }
  CHECK(std::ranges::all_of(bare.curves, [](const AssessedCurve& curve) { return curve.figures.empty(); }));
}

TEST_CASE("fewer curves are walked when so many are asked for, or few classes are expected to be unseen") {
  const ProblemStatement problem = load_instance("disulfide").problem;
  const std::size_t all = solved(problem, "explore").curves.size();
  const SolveRun few = solved(problem, "explore", {{"curves", "5"}});
  CHECK(few.status == RunStatus::partial);
  CHECK(few.curves.size() == 5);
  CHECK(few.solutions.size() >= 2);
  const SolveRun saturated = solved(problem, "explore", {{"unseen", "3"}});
  CHECK(saturated.curves.size() < all);
  CHECK(saturated.status == RunStatus::complete);
}
