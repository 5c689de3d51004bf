/// What explore reaches is counted against published numbers of real solutions. scripts/sweep-explore does the same on random
/// scenes, against those that monodromy finds.

#include "harness/sweeps/explore_check.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "harness/sweeps/random_scenes.hpp"

using namespace gcs;

TEST_CASE("real solutions and the components that hold them are as many as are published") {
  // Porta et al. 2007; Imbach, Mathis, Schreck 2016, table 1
  for (const auto& [id, published] : {std::pair{"disulfide", 18u}, {"octahedron", 4u}}) {
    const ExploreVerdict verdict = check_explore(load_instance(id).problem, 60);
    CAPTURE(id);
    CHECK(verdict.why_not.empty());
    CHECK(verdict.is_proven);
    CHECK(verdict.real == published);
    CHECK(std::accumulate(verdict.components.begin(), verdict.components.end(), std::size_t{0}) == published);
    CHECK(verdict.with_starts.solutions == published);
    CHECK(verdict.unexpected == 0);
  }
}

TEST_CASE("without random starts a sketch reaches whole components") {
  const ExploreVerdict verdict = check_explore(random_problem({3, 8}, 4), 60);
  REQUIRE(verdict.components.size() > 1);
  CHECK(std::ranges::count(verdict.components, verdict.from_sketch.solutions) > 0);
  CHECK(verdict.from_sketch.curves < verdict.with_starts.curves);
  CHECK(verdict.reaches_all());
}

TEST_CASE("without time there are no solutions to compare with") {
  const ExploreVerdict verdict = check_explore(load_instance("icosahedron").problem, 0.01);
  CHECK_FALSE(verdict.why_not.empty());
}

TEST_CASE("a problem of its sketch has it for a solution") {
  const std::vector<FoundSoFar> found = found_after(random_problem_of_sketch({2, 12}, 1), "explore", {5});
  REQUIRE(found.size() == 1);
  CHECK(found.front().solutions > 0);
  CHECK(found.front().cpu_s > 0);
}
