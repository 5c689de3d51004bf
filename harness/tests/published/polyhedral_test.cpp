/// The strategy polyhedral beside monodromy, which finds the same solutions in another way.

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tests/contract/report_agreement.hpp"

using namespace gcs;

namespace {

SolveReport solved(const std::string& strategy, const Scene& scene, const OptionMap& options = {}) {
  const StrategyEntry& entry = find_strategy(strategy);
  return entry.make(complete_options(entry, options))->solve(scene);
}

std::int64_t particular(const SolveReport& report, const std::string& name) {
  const auto found = std::find_if(report.particulars.begin(), report.particulars.end(),
                                  [&](const Particular& particular) { return particular.name == name; });
  return found == report.particulars.end() ? -1 : found->value;
}

void check_same(const std::string& instance, const OptionMap& options, std::int64_t mixed_volume) {
  INFO(instance);
  const Scene scene(load_instance(instance).problem);
  const SolveReport ours = solved("polyhedral", scene, options), theirs = solved("monodromy", scene);
  CHECK(ours.status == SolveStatus::complete);
  CHECK(theirs.status == SolveStatus::complete);
  CHECK(ours.generic == theirs.generic);
  CHECK(ours.candidates.size() == theirs.candidates.size());
  CHECK(contract::contradiction(scene, ours, theirs) == std::nullopt);
  CHECK(particular(ours, "mixed_volume") == mixed_volume);
  CHECK(particular(ours, "loop_paths") == -1);
  CHECK(particular(theirs, "loop_paths") > 0);
}

}  // namespace

// Mixed volumes: 2^m in the coordinates, which is Bézout's number; with spheres those of the multihomogeneous
// bounds of Bartzos, Emiris, Schicho 2020 for the octahedron and the disulfide bond.
TEST_CASE("polyhedral finds the solutions that monodromy finds") {
  check_same("octahedron", {}, 16);
  check_same("octahedron", {{"formulation", "coordinates"}}, 4096);
  check_same("disulfide", {}, 128);
  check_same("k33", {{"formulation", "coordinates"}}, 512);
}

TEST_CASE("polyhedral places a line") { check_same("hoffmann-yuan", {}, 512); }
