/// What a scan that leaves pieces undecided says of them.

#include "solvers/scanning/scan_report.hpp"

#include <catch2/catch.hpp>

#include "solvers/scanning/scan_plan.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

UndecidedPiece piece(std::vector<std::array<double, 2>> ranges) {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 6);
  return {std::move(ranges), std::move(figure)};
}

std::string reason_for(std::vector<UndecidedPiece> pieces) {
  const Scene scene(samples::octahedron());
  ScanOutcome outcome;
  outcome.undecided = std::move(pieces);
  const SolveReport report = scan_report(scene, derive_scan_plan(scene).ranges.size(), outcome);
  CHECK(report.status == SolveStatus::partial);
  return report.reason;
}

}  // namespace

TEST_CASE("every range that a scan could not decide is named, neighbours as one") {
  CHECK_THAT(reason_for({piece({{0.5, 0.625}}), piece({{0.625, 0.75}}), piece({{2, 2.5}})}),
             Catch::Contains("3 of the finest pieces undecided, at angles (radians) [0.5, 0.75], [2, 2.5]"));
  CHECK_THAT(reason_for({piece({{0, 1}, {0, 1}}), piece({{4, 5}, {0, 1}}), piece({{1, 2}, {1, 2}})}),
             Catch::Contains("[0, 2] x [0, 2], [4, 5] x [0, 1]"));
  std::vector<UndecidedPiece> many;
  for (int i = 0; i < 23; ++i) many.push_back(piece({{10.0 * i, 10.0 * i + 1}}));
  CHECK_THAT(reason_for(many),
             Catch::EndsWith("[190, 191] and 3 more: solutions there are multiple, or nearly so"));
  CHECK(reason_for({piece({})}) == "1 of the branches undecided: solutions there are multiple, or nearly so");
}
