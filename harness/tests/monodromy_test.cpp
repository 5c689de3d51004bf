/// The strategy monodromy on scenes that take too long for the contract tests.

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instance_io.hpp"
#include "harness/solve_run.hpp"
#include "harness/strategy_choice.hpp"

using namespace gcs;

namespace {

SolveRun solved(const std::string& instance, const OptionMap& options = {}, int threads = 1) {
  RunLimits limits;
  limits.threads = threads;
  return run_strategy(find_strategy("monodromy"), options, Scene(load_instance(instance).problem), limits);
}

}  // namespace

TEST_CASE("monodromy finds the dodecagon's solutions from nothing") {
  // Laman number 6180, half of it up to reflection: Capco et al. 2018. Imbach et al. 2016 have 2 real ones.
  const SolveRun run = solved("dodecagon");
  CHECK(run.status == RunStatus::complete);
  CHECK(run.assessment.counts.generic == 3090);
  CHECK(run.assessment.counts.complex_up_to_reflection == 3090);
  CHECK(run.assessment.counts.real_up_to_reflection == 2);
}

TEST_CASE("where the bound is not met a trace test completes the list") {
  // 16 solutions with a fixed frame against a bound of 32; found by independent programs (g16a); for the
  // pyramid Hoffmann and Yuan 2000 have 24 real ones in their frame, 6 up to reflection.
  const SolveRun run = solved("g16a");
  CHECK(run.status == RunStatus::complete);
  CHECK(run.assessment.counts.complex_up_to_reflection == 8);
  CHECK(solved("g16a", {{"trace", "off"}}).status == RunStatus::partial);
  CHECK(solved("hoffmann-yuan").assessment.counts.real_up_to_reflection == 6);
}

TEST_CASE("threads and instruction sets change no number of a solve") {
  const SolveRun one = solved("g160"), two = solved("g160", {{"instructions", "portable"}}, 2);
  CHECK(one.work.iterations == two.work.iterations);
  const auto &ours = one.assessment.solutions, &theirs = two.assessment.solutions;
  REQUIRE(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    CHECK(ours[i].figure.points == theirs[i].figure.points);
    CHECK(ours[i].figure.imaginary == theirs[i].figure.imaginary);
  }
}
