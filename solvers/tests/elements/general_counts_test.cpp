#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"

using namespace gcs;
using samples::random_octahedral;
using samples::random_platform;
using samples::RandomNumbers;

namespace {

Answer proven(const ProblemStatement& problem, std::uint64_t seed = 1) {
  return solve(Scene::unchecked(problem), "monodromy", {}, {.seed = seed, .certify = true});
}

/// Six planes of one body and six points of another, each point at its distance from its plane. `moving`: which body
/// the planes are in.
ProblemStatement points_at_planes(int moving, RandomNumbers& random) {
  ProblemStatement problem;
  RigidBody of_planes{"planes", {}}, of_points{"points", {}};
  for (int i = 0; i < 7; ++i) problem.points.push_back("p" + std::to_string(i));
  const auto decimals = [&](int count) {
    std::vector<Decimal> numbers;
    for (int k = 0; k < count; ++k) numbers.push_back({random.uniform(-1, 1), ""});
    return numbers;
  };
  for (int i = 0; i < 6; ++i) {
    of_points.elements.push_back({i, decimals(3)});
    problem.planes.push_back("h" + std::to_string(i));
    of_planes.elements.push_back({7 + i, decimals(4)});
    problem.relations.push_back({"c" + std::to_string(i),
                                 "distance",
                                 {{i}, {7 + i}},
                                 Relation::Form::length,
                                 {random.uniform(-1, 1), ""}});
  }
  of_planes.elements.push_back({6, decimals(3)});
  problem.bodies = {of_planes, of_points};
  problem.reference_body = moving == 0 ? 1 : 0;
  return problem;
}

}  // namespace

TEST_CASE("a general platform has 40 postures, and one in the plane 6") {
  RandomNumbers random(11);
  for (const auto& [dimension, count] : {std::pair(3, 40), std::pair(2, 6)})
    for (int i = 0; i < 2; ++i) {
      const Answer answer = proven(random_platform(dimension, random));
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.failed_checks.empty());
      CHECK(answer.solutions.size() == static_cast<std::size_t>(count));
      REQUIRE(answer.proofs);
      CHECK(answer.proofs->are_complete());
      CHECK(answer.proofs->generic == static_cast<std::uint64_t>(count));
      CHECK(answer.proofs->real >= 1);
    }
}

TEST_CASE(
    "six points of a body at their distances from six planes of another: 8 postures, the degree of SO(3)") {
  RandomNumbers random(14);
  for (const int moving : {0, 1}) {
    const Answer answer = proven(points_at_planes(moving, random));
    INFO(answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    CHECK(answer.solutions.size() == 8);
    REQUIRE(answer.proofs);
    CHECK(answer.proofs->classes == 8);
  }
}

TEST_CASE("the equations of lines and planes of a body hold where it stands") {
  RandomNumbers random(15);
  ProblemStatement problem;
  problem.points = {"a", "b", "c", "p", "q"};
  problem.lines = {"L"};
  problem.planes = {"E"};
  const Eigen::Matrix3Xd base = random.points(3, 3, 1), own = random.points(3, 2, 1);
  const LinePosition line{random.point(3, 1), random.point(3, 3)};
  const PlanePosition plane{random.point(3, 3), 0.7};
  const auto decimals = [](std::initializer_list<Eigen::Vector3d> vectors) {
    std::vector<Decimal> numbers;
    for (const Eigen::Vector3d& v : vectors)
      for (const double x : v) numbers.push_back({x, ""});
    return numbers;
  };
  RigidBody fixed{"base", {}}, moved{"moved", {}};
  for (int i = 0; i < 3; ++i) fixed.elements.push_back({i, decimals({base.col(i)})});
  for (int i = 0; i < 2; ++i) moved.elements.push_back({3 + i, decimals({own.col(i)})});
  moved.elements.push_back({5, decimals({line.point, line.direction})});
  moved.elements.push_back({6, decimals({plane.normal})});
  moved.elements.back().numbers.push_back({plane.offset, ""});
  problem.bodies = {fixed, moved};
  problem.reference_body = 0;
  const Eigen::Quaterniond turn = samples::random_turn(3, random);
  const Eigen::Vector3d shift = random.point(3, 2);
  Figure figure;
  figure.points.resize(3, 5);
  figure.points << base, (turn * own.col(0) + shift), (turn * own.col(1) + shift);
  const Eigen::Vector3d normal = (turn * plane.normal).normalized();
  figure.lines = {{turn * line.point + shift, (turn * line.direction).normalized()}};
  figure.planes = {{normal, plane.offset / plane.normal.norm() + normal.dot(shift)}};
  const double to_line = (base.col(0) - figure.lines[0].point).cross(figure.lines[0].direction).norm();
  problem.constraints.push_back({"d", {0, 5}, {to_line, ""}, false});
  problem.relations.push_back({"h",
                               "distance",
                               {{1}, {6}},
                               Relation::Form::length,
                               {normal.dot(base.col(1)) - figure.planes[0].offset, ""}});
  const Scene scene = Scene::unchecked(problem);
  REQUIRE_FALSE(why_no_system(scene));
  CHECK(relative_residual(scene, figure.scaled(-scene.unit_exponent())) <= 1e-14);
  figure.planes[0].offset += 1e-3;
  CHECK(relative_residual(scene, figure.scaled(-scene.unit_exponent())) > 1e-5);
}

TEST_CASE("octahedral scenes with up to three planes have 8 solutions up to reflection") {
  RandomNumbers random(12);
  for (const int planes : {1, 2, 3}) {
    const Answer answer = proven(random_octahedral(planes, random));
    INFO(planes << " planes: " << answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    CHECK(answer.solutions.size() == 8);
    REQUIRE(answer.proofs);
    CHECK(answer.proofs->classes == 8);
    CHECK(answer.proofs->are_complete());
    CHECK(answer.proofs->real >= 1);
  }
}

TEST_CASE("an octahedral scene with given positions, or with other pairs, has no bound of its own") {
  RandomNumbers random(17);
  ProblemStatement problem = random_octahedral(1, random);
  CHECK(theoretical_counts(problem).upper_limit()->up_to_reflection() == Natural(8));
  ProblemStatement turned = problem;
  for (Relation& relation : turned.relations)
    if (relation.type == "distance") relation.type = "angle";
  CHECK_FALSE(theoretical_counts(turned).upper_limit());
  problem.fixed_points.assign(problem.points.size(), Eigen::Vector3d::Zero());
  CHECK_FALSE(theoretical_counts(problem).upper_limit());
}

TEST_CASE("three points and three lines have as many figures as the curves of their directions meet in") {
  // 12³ less 6·128, and 12 for each angle and 24 for each distance: three_lines_bound.hpp.
  RandomNumbers random(18);
  ProblemStatement problem = samples::sketched_points_and_lines(random);
  const auto most = [](const ProblemStatement& scene) {
    const TheoreticalCounts counts = theoretical_counts(scene);
    return counts.upper_limit() == nullptr ? Natural(0) : counts.upper_limit()->up_to_reflection();
  };
  CHECK(most(problem) == Natural(960));
  ProblemStatement given = problem, parallel = problem;
  given.fixed_points.assign(given.points.size(), Eigen::Vector3d::Zero());
  CHECK(most(given) > Natural(2 * 960));  // by another theorem, of mirror images one by one
  parallel.relations.back().type = "parallel";
  CHECK(most(parallel) == Natural(0));
  for (const int expected : {12 * 12 * 24, 12 * 24 * 24, 24 * 24 * 24}) {
    const auto angle = std::ranges::find(problem.relations, "angle", &Relation::type);
    angle->type = "distance";
    angle->form = Relation::Form::length;
    CHECK(most(problem) == Natural(static_cast<std::uint64_t>(expected)));
  }
}

TEST_CASE("loops find the postures of a general platform along a few times as many paths") {
  RandomNumbers random(16);
  const Scene scene = Scene::unchecked(random_platform(3, random));
  constexpr std::uint64_t seeds = 6;
  std::int64_t paths = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Answer answer = solve(scene, Monodromy{.seed = seed});
    CHECK(answer.status == RunStatus::complete);
    for (const Particular& particular : answer.particulars)
      if (particular.name == "loop_paths") paths += particular.value;
  }
  CHECK(paths <= static_cast<std::int64_t>(seeds * 8 * 40));
}

TEST_CASE("the unit of a general scene changes no bit, however small or large") {
  RandomNumbers random(13);
  const ProblemStatement problem = random_octahedral(2, random);
  const Answer answer = proven(problem);
  for (const int exponent : {-500, 500}) {
    ProblemStatement scaled = problem;
    const auto scale = [&](Decimal& length) { length.value = std::ldexp(length.value, exponent); };
    for (DistanceConstraint& c : scaled.constraints) scale(c.given);
    for (Relation& r : scaled.relations)
      if (r.form == Relation::Form::length) scale(r.given);
    const Answer other = proven(scaled);
    REQUIRE(other.solutions.size() == answer.solutions.size());
    for (std::size_t i = 0; i < answer.solutions.size(); ++i) {
      CHECK(other.solutions[i].figure.points == answer.solutions[i].figure.points);
      CHECK(other.solutions[i].error_bound == answer.solutions[i].error_bound);
    }
  }
}
