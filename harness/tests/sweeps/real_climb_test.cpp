#include "harness/sweeps/real_climb.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/solving/solve.hpp"

using namespace gcs;

namespace {

/// 120 points on the way are far more than graphs of seven points take.
Climb climb_from(const ProblemStatement& problem, std::uint64_t seed) {
  int scenes = 0;
  return climb_to_real(problem, {.seed = seed, .stopped = [&scenes] { return ++scenes > 120; }});
}

std::size_t proven_real(const ProblemStatement& problem) {
  SolveSettings settings;
  settings.certify = true;
  const Answer answer = solve(Scene(problem), "monodromy", {}, settings);
  return answer.proofs ? answer.proofs->real : 0;
}

}  // namespace

// Half of what Capco et al. 2018, table 1, count with mirror images; of the prism they found lengths at which all are
// real.
TEST_CASE("a climb from random lengths ends where all realisations are real") {
  for (const auto& [id, published] : {std::pair{"laman-most@6", 12u}, {"laman-most@7", 28u}}) {
    CAPTURE(id);
    const Climb climb = climb_from(load_instance(id).problem, 1);
    CHECK(climb.real_at_start < published);
    CHECK(climb.top.all == published);
    CHECK(climb.top.real == published);
    CHECK(proven_real(climb.top.problem) == published);
  }
}

TEST_CASE("a climb has its top at the start where all is real or no time is left") {
  const ProblemStatement all_real = load_instance("g48").problem, other = load_instance("octahedron").problem;
  const Climb first = climb_from(all_real, 1);
  CHECK(first.scenes == 1);
  CHECK(first.top.real == first.top.all);
  const Climb second = climb_to_real(other, {.stopped = [] { return true; }});
  CHECK(second.scenes == 1);
  CHECK(second.top.real == second.real_at_start);
}
