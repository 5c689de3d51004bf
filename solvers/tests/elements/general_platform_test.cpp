#include <catch2/catch.hpp>

#include "solvers/solving/solve.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;

TEST_CASE("mixed cells lead to the 40 postures of a general platform") {
  samples::RandomNumbers random(31);
  const Answer answer = solve(Scene::unchecked(samples::random_platform(3, random)),
                              Polyhedral{.seed = 2, .threads = 2, .certify = true});
  INFO(answer.reason);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.failed_checks.empty());
  CHECK(answer.solutions.size() == 40);
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->are_complete());
  CHECK(answer.proofs->real >= 1);
}
