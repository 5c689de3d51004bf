#include "solvers/construction/hypotheses.hpp"

#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// p1 and p2 on the x-axis, p3 beside them; the sides from a sketch to a target, of which one is bent or none.
Scene triangle(const std::array<double, 3>& sketch, const std::array<double, 3>& target, int bent,
               double bend) {
  const auto placed = [](const std::array<double, 3>& sides) {  // |p1p2|, |p1p3|, |p2p3|
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
    points(0, 1) = sides[0];
    const double x = (sides[0] * sides[0] + sides[1] * sides[1] - sides[2] * sides[2]) / (2 * sides[0]);
    points.col(2) << x, std::sqrt(sides[1] * sides[1] - x * x), 0;
    return points;
  };
  ProblemStatement problem = samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, placed(sketch), placed(target));
  problem.interpolation.bends.emplace();
  if (bent >= 0) problem.interpolation.bends->push_back({bent, {bend}});
  return Scene(problem);
}

PlanHypotheses check(const Scene& scene) {
  const Plan plan = derive_plan(scene, *scene.sketch(), {});
  return check_hypotheses(scene, plan, in_plan_frame(scene, plan, *scene.sketch()), 0.1);
}

}  // namespace

TEST_CASE("nothing fails in a triangle of which one side is bent and no two are alike") {
  const PlanHypotheses fails = check(triangle({3, 4, 5}, {3.5, 4.25, 4.75}, 2, 2));
  CHECK(fails.h2 == 0);
  CHECK(fails.h3 == 0);
  CHECK(fails.h5 == 0);
  CHECK(fails.h7 == 0);
}

TEST_CASE("(h2) fails where no side is bent and none shrinks") {
  // Growing sides: positive for all t > 0, and each negative somewhere below 0.
  CHECK(check(triangle({3, 4, 5}, {4, 5, 6}, -1, 0)).h2 == 1);
  // Sides that stay as they are.
  CHECK(check(triangle({3, 4, 5}, {3, 4, 5}, -1, 0)).h2 == 2);
}

TEST_CASE("(h3) fails for each pair of sides that are alike all along") {
  CHECK(check(triangle({3, 4, 4}, {3.5, 5, 5}, 0, 2)).h3 == 1);
  CHECK(check(triangle({4, 4, 4}, {5, 5, 5}, -1, 0)).h3 == 3);
  CHECK(check(triangle({3, 4, 4}, {3.5, 5, 5}, 1, 2)).h3 == 0);
}

TEST_CASE("(h4) and (h5) fail where the sides in question vanish first") {
  // All in proportion: they vanish together, at t = −3.
  const PlanHypotheses together = check(triangle({3, 4, 5}, {4, 16.0 / 3, 20.0 / 3}, -1, 0));
  CHECK(together.h4 == 1);
  CHECK(together.h5 == 1);
  // The last two vanish at t = −4, p1p2 not at all.
  const PlanHypotheses last = check(triangle({3, 4, 4}, {3, 5, 5}, -1, 0));
  CHECK(last.h4 + last.h5 >= 1);
}

TEST_CASE("(h7) fails for a flat sketch") {
  CHECK(check(triangle({3, 4, 6.999}, {3, 4, 5}, 0, 2)).h7 == 1);
  CHECK(check(triangle({3, 4, 5}, {3, 4, 6.999}, 0, 2)).h7 == 0);
}
