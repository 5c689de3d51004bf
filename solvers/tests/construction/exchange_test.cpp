#include "solvers/construction/exchange.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Builds the figure again from its own distances and the plan's branch.
double rebuilding_error(const Scene& scene, Plan plan, const Eigen::Matrix3Xd& figure) {
  std::vector<double> driven;
  for (Instruction& instruction : plan.instructions()) {
    instruction.side = side_of(instruction, figure);
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven())
        driven.push_back((figure.col(instruction.place) - instruction.spheres[i].reference).norm());
  }
  const auto radius = [&](const PlanSphere& sphere, int j) {
    if (sphere.is_driven()) return driven[j];
    const auto [a, b] = scene.problem().constraints[sphere.constraint].between;
    return (figure.col(a) - figure.col(b)).norm();
  };
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, figure.cols());
  if (!evaluate_plan(plan, 0, radius, points)) return std::numeric_limits<double>::infinity();
  return (points - figure).cwiseAbs().maxCoeff();
}

int exchanged(const Plan& plan) {
  int count = 0;
  for (const Instruction& instruction : plan.instructions())
    for (const auto& original : instruction.original) count += original ? 1 : 0;
  return count;
}

bool same_spheres(const Plan& a, const Plan& b) {
  for (std::size_t k = 0; k < a.instructions().size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const PlanSphere& s = a.instructions()[k].spheres[i];
      const PlanSphere& t = b.instructions()[k].spheres[i];
      if (s.center != t.center || s.constraint != t.constraint || s.reference != t.reference) return false;
    }
  return true;
}

/// What happened during a walk, to see that the samples meet every case.
struct Events {
  int changes = 0;
  int exchanges = 0;
  int restorations = 0;
  double worst_rebuilding = 0;
};

/// Changes the plan at one random figure after another: nothing ties it to a path.
void walk(const Scene& scene, const ExchangeRule& rule, int figures, RandomNumbers& random, Events& events) {
  Plan plan = derive_plan(scene, *scene.sketch(), rule);
  const int driving_at_first = plan.driving_parameters();
  for (int i = 0; i < figures; ++i) {
    const Figure figure{random.points(scene.dimension(), scene.point_count(), 1), {}};
    const Eigen::Matrix3Xd points = in_plan_frame(scene, plan, figure).points;
    const Plan before = plan;
    const bool needed = needs_change(plan, rule, points);
    const bool changed = change_plan(plan, rule, points).is_any();
    // Algorithm 2 also restores what could stay exchanged, so that it may change more than it has to.
    if (needed) CHECK(changed);
    CHECK(changed != same_spheres(before, plan));
    CHECK_FALSE(needs_change(plan, rule, points));
    CHECK_FALSE(change_plan(plan, rule, points).is_any());
    CHECK(static_cast<int>(plan.removed().size()) == plan.driving_parameters());
    CHECK(plan.driving_parameters() == driving_at_first + exchanged(plan));
    events.worst_rebuilding = std::max(events.worst_rebuilding, rebuilding_error(scene, plan, points));
    events.changes += changed ? 1 : 0;
    events.exchanges += std::max(0, exchanged(plan) - exchanged(before));
    events.restorations += std::max(0, exchanged(before) - exchanged(plan));
  }
}

/// p3 = interCC(p1, a_first, p2, a_second) in the plane.
Plan triangle_plan() {
  std::vector<Instruction> instructions(3);
  for (int p = 0; p < 3; ++p) {
    instructions[p].place = p;
    instructions[p].count = p;
  }
  instructions[1].spheres[0] = {0, 0, Eigen::Vector3d::Zero()};
  instructions[2].spheres[0] = {0, 1, Eigen::Vector3d::Zero()};
  instructions[2].spheres[1] = {1, 2, Eigen::Vector3d::Zero()};
  return Plan(2, 3, instructions);
}

Eigen::Matrix3Xd triangle(double x, double y) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points(0, 1) = 2;
  points.col(2) << x, y, 0;
  return points;
}

}  // namespace

TEST_CASE("a changed plan builds the same figure, needs no further change, and keeps its equations") {
  RandomNumbers random(1);
  for (const bool watch_sine : {true, false})
    for (const double alpha : {0.1, 0.3, 0.45}) {
      CAPTURE(watch_sine, alpha);
      Events events;
      for (int sample = 0; sample < 24; ++sample) {
        const int dimension = 2 + sample % 2;
        const Scene scene(samples::random_problem(dimension, 5 + random.index(4), random));
        walk(scene, {alpha, watch_sine}, 12, random, events);
      }
      CHECK(events.changes > 50);
      CHECK(events.exchanges > 20);
      CHECK(events.restorations > 20);
      // γ alone does not see centres that come together.
      CHECK(events.worst_rebuilding <= (watch_sine ? 1e-12 : 1e-9));
    }
}

TEST_CASE("far from all boundaries nothing is changed") {
  Plan plan = triangle_plan();
  const Plan before = plan;
  CHECK_FALSE(needs_change(plan, {}, triangle(1, 1)));
  CHECK_FALSE(change_plan(plan, {}, triangle(1, 1)).is_any());
  CHECK(same_spheres(plan, before));
}

TEST_CASE("near a boundary the smaller radius is exchanged for a driving parameter and restored later") {
  const ExchangeRule rule;
  Plan plan = triangle_plan();
  const Eigen::Matrix3Xd flat = triangle(0.7, 0.05);
  REQUIRE(needs_change(plan, rule, flat));
  REQUIRE(change_plan(plan, rule, flat).is_any());
  const Instruction& last = plan.instructions()[2];
  // |p1 p3| = 0.7 and |p2 p3| = 1.3: the arguments were swapped so that the larger one stays.
  CHECK(last.spheres[0].constraint == 2);
  CHECK(last.spheres[1].is_driven());
  CHECK(last.spheres[1].center == 0);
  REQUIRE(last.original[1]);
  CHECK(last.original[1]->constraint == 1);
  CHECK(plan.removed() == std::vector<int>{1});
  CHECK(boundary_distance(plan, rule, flat) > 0.7);

  SECTION("while the original is near its boundary, the exchange stays") {
    const Plan before = plan;
    CHECK_FALSE(change_plan(plan, rule, triangle(0.7, -0.05)).is_any());
    CHECK(same_spheres(plan, before));
  }
  SECTION("when the original is far from its boundary, it comes back") {
    REQUIRE(change_plan(plan, rule, triangle(1, 1)).is_any());
    CHECK(plan.driving_parameters() == 0);
    CHECK(plan.removed().empty());
    CHECK_FALSE(plan.instructions()[2].original[1]);
    CHECK(plan.instructions()[2].spheres[1].constraint == 1);
  }
  SECTION("(sc1): when the original's radii change places, the other constraint is exchanged") {
    const Eigen::Matrix3Xd beyond = triangle(1.2, 0.05);
    CHECK(needs_change(plan, rule, beyond));
    REQUIRE(change_plan(plan, rule, beyond).is_any());
    CHECK(plan.instructions()[2].spheres[0].constraint == 1);
    CHECK(plan.instructions()[2].spheres[1].is_driven());
    CHECK(plan.removed() == std::vector<int>{2});
    CHECK_FALSE(needs_change(plan, rule, beyond));
  }
}

TEST_CASE("a sphere driven from the start is shifted near its boundary and has no original to restore") {
  const ExchangeRule rule;
  Plan plan = triangle_plan();
  PlanSphere& driven = plan.instructions()[2].spheres[1];
  driven.constraint = -1;
  driven.reference << 2, 0.1, 0;
  plan.renew_indices();
  REQUIRE(plan.removed() == std::vector<int>{2});
  CHECK_FALSE(change_plan(plan, rule, triangle(1, 1)).is_any());
  const Eigen::Matrix3Xd near = triangle(1, 0);
  REQUIRE(boundary_distance(plan, rule, near) <= rule.alpha);
  REQUIRE(change_plan(plan, rule, near).is_any());
  CHECK(boundary_distance(plan, rule, near) > 0.7);
  CHECK(plan.driving_parameters() == 1);
  CHECK(plan.removed() == std::vector<int>{2});
  CHECK_FALSE(plan.instructions()[2].original[1]);
  CHECK(driven.center == 1);
}

TEST_CASE("without watching the sine, centres that come together are not noticed") {
  Plan plan = triangle_plan();
  Eigen::Matrix3Xd points = triangle(0.01, 1);
  points(0, 1) = 0.02;
  CHECK_FALSE(needs_change(plan, {0.1, false}, points));
  CHECK(needs_change(plan, {0.1, true}, points));
}

TEST_CASE("as printed, an exchange cannot be undone: the plan stays and the point is named") {
  ExchangeRule rule;
  rule.restores_as_printed = true;
  Plan plan = triangle_plan();
  REQUIRE(change_plan(plan, rule, triangle(0.7, 0.05)).exchanges == 1);
  const Plan before = plan;
  const PlanChange change = change_plan(plan, rule, triangle(1, 1));
  REQUIRE(change.undefined);
  CHECK(change.undefined->place == 2);
  CHECK_FALSE(change.is_any());
  CHECK(same_spheres(plan, before));
  CHECK(plan.driving_parameters() == 1);
}

TEST_CASE("as printed, there is no shift from the line of the centres") {
  ExchangeRule rule;
  rule.shift.towards_projection = true;
  Plan plan = triangle_plan();
  const Plan before = plan;
  const PlanChange change = change_plan(plan, rule, triangle(0.7, 0));
  REQUIRE(change.undefined);
  CHECK_FALSE(change.is_any());
  CHECK(same_spheres(plan, before));
}

TEST_CASE("shifts against Proposition 2 are counted, and there are none where it holds") {
  // p4 on the circle of radius 1 about the axis of p1 and p2, which p3 meets at 12: to within α of tangency.
  std::vector<Instruction> instructions(4);
  for (int p = 0; p < 4; ++p) {
    instructions[p].place = p;
    instructions[p].count = p;
  }
  int constraint = 0;
  for (int p = 1; p < 4; ++p)
    for (int i = 0; i < p; ++i) instructions[p].spheres[i] = {i, constraint++, Eigen::Vector3d::Zero()};
  Eigen::Matrix3Xd points(3, 4);
  points << 0, 0, 13, std::cos(1e-3), 0, 0, 0, std::sin(1e-3), 1, -2, 0, 0;
  for (const bool as_printed : {true, false}) {
    ExchangeRule rule;
    rule.shift.larger_radius = as_printed;
    rule.watch_sine = false;
    Plan plan(3, 6, instructions);
    const PlanChange change = change_plan(plan, rule, points);
    CHECK(change.shifts == 1);
    CHECK(change.shifts_in_vain == (as_printed ? 1 : 0));
    CHECK(needs_change(plan, rule, points) == as_printed);
  }
}
