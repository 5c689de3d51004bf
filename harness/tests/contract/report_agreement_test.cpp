/// Reports that differ as two right ones may, and reports that contradict.

#include "harness/tests/contract/report_agreement.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/contract/spoiled_strategy.hpp"
#include "harness/tests/contract/strategy_contract.hpp"

using namespace gcs;
using namespace gcs::contract;

namespace {

const Scene& disulfide() {
  static const Scene scene(load_instance("disulfide").problem);
  return scene;
}

SolveReport sound_report() { return solve_anew({sound_strategy()}, disulfide()); }

}  // namespace

TEST_CASE("a round may begin anywhere and go either way") {
  const SolveReport sound = sound_report();
  SolveReport other = sound;
  std::vector<Crossing>& crossings = other.paths[0].crossings;
  std::rotate(crossings.begin(), crossings.begin() + 3, crossings.end());
  CHECK_FALSE(contradiction(disulfide(), sound, other));
  std::reverse(crossings.begin(), crossings.end());
  CHECK(contradiction(disulfide(), sound, other));  // the directions are those of the other way round
  for (Crossing& crossing : crossings) crossing.direction *= -1;
  CHECK_FALSE(contradiction(disulfide(), sound, other));
}

TEST_CASE("another order along the path contradicts") {
  const SolveReport sound = sound_report();
  SolveReport other = sound;
  std::swap(other.candidates[1], other.candidates[3]);
  CHECK(contradiction(disulfide(), sound, other));
  CHECK_FALSE(outsider(disulfide(), other, sound));
}

TEST_CASE("paths without a crossing agree with each other only") {
  const SolveReport sound = sound_report();
  SolveReport none = sound;
  none.candidates.clear();
  none.paths[0].crossings.clear();
  CHECK_FALSE(contradiction(disulfide(), none, none));
  CHECK(contradiction(disulfide(), sound, none));
}

TEST_CASE("an exhaustive claim that lacks a class contradicts") {
  const SolveReport sound = sound_report();
  SolveReport all = sound;
  all.claim = Claim::all_real;
  CHECK_FALSE(contradiction(disulfide(), sound, all));
  CHECK_FALSE(contradiction(disulfide(), all, sound));
  all.candidates.resize(1);
  CHECK(contradiction(disulfide(), sound, all));
  CHECK(contradiction(disulfide(), all, sound));
}
