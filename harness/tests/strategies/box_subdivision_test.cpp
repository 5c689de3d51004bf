/// The strategy box-subdivision against other methods, on scenes that are not shipped.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tests/contract/problem_restatements.hpp"
#include "harness/tests/contract/report_agreement.hpp"
#include "harness/tests/strategies/tangent_samples.hpp"

using namespace gcs;

namespace {

/// Nothing where the strategy does not support the scene.
std::optional<SolveReport> report_of(const Scene& scene, const std::string& strategy,
                                     const OptionMap& given = {}) {
  const StrategyEntry entry = find_strategy(strategy);
  const auto made = entry.make(complete_options(entry, given));
  const SolveRequest request(scene);
  if (made->why_unsupported(request)) return std::nullopt;
  made->prepare(request);
  return made->solve(request);
}

/// Compares the classes of both; returns how many the subdivision has.
std::size_t compared(const ProblemStatement& problem, const std::string& other, const OptionMap& given = {}) {
  const Scene scene = Scene::unchecked(problem);
  const auto ours = report_of(scene, "box-subdivision", given), theirs = report_of(scene, other);
  REQUIRE(ours);
  REQUIRE(theirs);
  CHECK(ours->status == SolveStatus::complete);
  CHECK(theirs->status == SolveStatus::complete);
  const auto found = contract::contradiction(scene, *ours, *theirs);
  INFO(found.value_or(""));
  CHECK_FALSE(found);
  return ours->candidates.size();
}

/// The pyramid of Hoffmann and Yuan with the lengths of a random placement whose line is the x-axis.
ProblemStatement random_pyramid(Dice& dice) {
  ProblemStatement problem = load_instance("hoffmann-yuan").problem;
  const Eigen::Matrix3Xd points =
      Eigen::Matrix3Xd::NullaryExpr(3, 5, [&](Eigen::Index, Eigen::Index) { return 5 * dice(); });
  for (DistanceConstraint& c : problem.constraints) {
    const auto a = std::min(c.between[0], c.between[1]), b = std::max(c.between[0], c.between[1]);
    const Eigen::Vector3d p = points.col(a);
    c.given = {b < 5 ? (p - points.col(b)).norm() : p.tail<2>().norm(), ""};
    c.is_squared = false;
  }
  return problem;
}

}  // namespace

TEST_CASE("boxes and plans have the same solutions at random lengths") {
  std::mt19937_64 random(44);
  for (const std::string id : {"k33", "octahedron"}) {
    std::size_t solutions = 0;
    for (int i = 0; i < 20; ++i) {
      const ProblemStatement problem = contract::with_random_targets(load_instance(id).problem, random);
      solutions += compared(problem, "plan-scan");
      if (i < 5) compared(problem, "plan-scan", {{"reduction", "box"}});
    }
    CHECK(solutions >= 20);
  }
}

TEST_CASE("interval Newton and bisection alone are right too, where they end") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 3; ++i)
    compared(contract::with_random_targets(load_instance("k33").problem, random), "plan-scan",
             {{"reduction", "none"}});
}

TEST_CASE("boxes and the scan of an angle have the same solutions of random pyramids and their lines") {
  Dice dice(5);
  std::size_t solutions = 0;
  for (int i = 0; i < 8; ++i) solutions += compared(random_pyramid(dice), "theta-scan");
  CHECK(solutions >= 8);
}

TEST_CASE("boxes hold the real lines beside four random points, coplanar ones too") {
  Dice dice(41);
  std::size_t solutions = 0;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d shape(1, 1, i % 3 == 0 ? 0 : 1);
    solutions += compared(dice.problem(shape.asDiagonal()), "sphere-tangents");
  }
  CHECK(solutions > 0);
}

// Every two of four equal spheres around the corners of a regular tetrahedron touch: three lines of
// multiplicity 4, through the middles of opposite edges.
TEST_CASE("lines that are multiple are proven to be, and no others are") {
  Eigen::Matrix<double, 3, 4> centers;
  centers << 3, 3, -3, -3, 3, -3, 3, -3, 3, -3, -3, 3;
  const Eigen::Vector3d middle(1, 2, 3);
  ProblemStatement problem = spheres(centers.colwise() + middle, Eigen::Vector4d::Zero());
  for (DistanceConstraint& c : problem.constraints) {
    c.given = {18, ""};
    c.is_squared = true;
  }
  const Scene scene(problem);
  const auto report = report_of(scene, "box-subdivision");
  REQUIRE(report);
  CHECK(report->status == SolveStatus::complete);
  CHECK(report->candidates.size() == 3);
  for (int axis = 0; axis < 3; ++axis) {
    const auto is_line = [&](const Candidate& candidate) {
      const LinePosition line = scene.in_file_unit(candidate.figure).lines.front();
      return line.direction.cross(Eigen::Vector3d::Unit(axis)).norm() < 1e-14 &&
             (line.point - middle).cross(Eigen::Vector3d::Unit(axis)).norm() < 1e-14 &&
             candidate.multiplicity == 4;
    };
    CHECK(std::any_of(report->candidates.begin(), report->candidates.end(), is_line));
  }
}
