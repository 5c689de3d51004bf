#include "solvers/construction/plan.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Places point 3 from the points 0, 1 and 2, some of them as fixed copies.
Instruction random_instruction(int count, const Eigen::Matrix3Xd& points, RandomNumbers& random) {
  Instruction instruction;
  instruction.place = 3;
  instruction.count = count;
  for (int i = 0; i < count; ++i) {
    instruction.spheres[i].center = i;
    instruction.spheres[i].constraint = random.index(3) > 0 ? i : -1;
    instruction.spheres[i].reference = points.col(i);
  }
  return instruction;
}

std::array<double, 3> radii_at(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  std::array<double, 3> radii{};
  for (int i = 0; i < instruction.count; ++i) {
    const Eigen::Vector3d arm = points.col(instruction.place) - center_of(instruction.spheres[i], points);
    radii[i] = arm.norm();
  }
  return radii;
}

double radius_error(const Instruction& instruction, const std::array<double, 3>& radii,
                    const Eigen::Matrix3Xd& points) {
  const std::array<double, 3> found = radii_at(instruction, points);
  double worst = 0;
  for (int i = 0; i < instruction.count; ++i) worst = std::max(worst, std::abs(found[i] - radii[i]));
  return worst;
}

/// The smallest height of the simplex of point 3 and its centres: what the intersection's accuracy hangs on.
double height(int count, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d a = points.col(1) - points.col(0);
  const Eigen::Vector3d p = points.col(3) - points.col(0);
  const double area = a.cross(p).norm();
  if (count == 2) return std::min(area, area / a.norm());
  const Eigen::Vector3d b = points.col(2) - points.col(0);
  const double volume = std::abs(a.cross(b).dot(p));
  return std::min(volume, volume / a.cross(b).norm());
}

/// A chain: origin, axis point, and every further point from its predecessors.
Plan chain(int dimension, int points) {
  std::vector<Instruction> instructions;
  int constraints = 0;
  for (int p = 0; p < points; ++p) {
    Instruction instruction;
    instruction.place = p;
    instruction.count = std::min(p, dimension);
    for (int i = 0; i < instruction.count; ++i) {
      PlanSphere& sphere = instruction.spheres[i];
      sphere.center = p - 1 - i;
      // Every third point has a driven sphere.
      const bool driven = p % 3 == 0 && i == instruction.count - 1 && i > 0;
      if (!driven) sphere.constraint = constraints++;
      sphere.reference = Eigen::Vector3d(0.3 * p, -0.2 * p, dimension == 3 ? 0.1 * p : 0);
    }
    instructions.push_back(instruction);
  }
  return Plan(dimension, constraints + 2, instructions);
}

}  // namespace

TEST_CASE("a point is placed at its distances from the centres, on either branch") {
  RandomNumbers random(1);
  double worst = 0;
  double farthest = 0;
  for (int sample = 0; sample < 5000; ++sample) {
    const int count = 2 + sample % 2;
    Eigen::Matrix3Xd points = random.points(count, 4, 1);
    const Instruction original = random_instruction(count, points, random);
    if (height(count, points) < 0.05) continue;
    const std::array<double, 3> radii = radii_at(original, points);
    const int side_of_point = side_of(original, points);
    for (const int side : {1, -1}) {
      Instruction instruction = original;
      instruction.side = side;
      Eigen::Matrix3Xd placed = points;
      placed.col(3).setConstant(99);
      REQUIRE(place(instruction, radii, placed));
      worst = std::max(worst, radius_error(instruction, radii, placed));
      CHECK(side_of(instruction, placed) == side);
      CHECK(placed.leftCols<3>() == points.leftCols<3>());
      if (count == 2) CHECK(placed(2, 3) == 0);
      const double distance = (placed.col(3) - points.col(3)).norm();
      if (side == side_of_point)
        farthest = std::max(farthest, distance);
      else
        CHECK(distance > 0.05);
    }
  }
  CHECK(worst <= 1e-12);
  CHECK(farthest <= 1e-12);
}

TEST_CASE("the first points of a plan go to the origin and to the positive x-axis") {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, 4, 7);
  Instruction instruction;
  instruction.place = 2;
  REQUIRE(place(instruction, {}, points));
  CHECK(points.col(2).isZero(0));
  CHECK(side_of(instruction, points) == 1);

  instruction.place = 3;
  instruction.count = 1;
  instruction.spheres[0] = {2, 0, Eigen::Vector3d::Zero()};
  REQUIRE(place(instruction, {1.5}, points));
  CHECK(points.col(3) == Eigen::Vector3d(1.5, 0, 0));
  CHECK_FALSE(place(instruction, {0.0}, points));
  CHECK_FALSE(place(instruction, {-1.0}, points));
}

TEST_CASE("circles that do not meet have no intersection") {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(1) << 4, 0, 0;
  Instruction circles;
  circles.place = 3;
  circles.count = 2;
  circles.spheres[0] = {0, 0, Eigen::Vector3d::Zero()};
  circles.spheres[1] = {1, 1, Eigen::Vector3d::Zero()};
  CHECK_FALSE(place(circles, {1, 2.9}, points));
  CHECK_FALSE(place(circles, {1, 5.1}, points));
  CHECK_FALSE(place(circles, {5.1, 1}, points));
  CHECK(place(circles, {1, 3}, points));
  CHECK(points.col(3) == Eigen::Vector3d(1, 0, 0));
  CHECK(place(circles, {1, 5}, points));
  CHECK(points.col(3) == Eigen::Vector3d(-1, 0, 0));
  points.col(1) = points.col(0);
  CHECK_FALSE(place(circles, {1, 1}, points));
  CHECK_FALSE(place(circles, {1, std::numeric_limits<double>::quiet_NaN()}, points));
}

TEST_CASE("spheres that do not meet have no intersection") {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(0) << 0, 0, 3;
  points.col(1) << 0, 0, -3;
  points.col(2) << 10, 0, 2;
  Instruction spheres;
  spheres.place = 3;
  spheres.count = 3;
  for (int i = 0; i < 3; ++i) spheres.spheres[i] = {i, i, Eigen::Vector3d::Zero()};
  // The circle has radius 4 in the plane z = 0; the third centre is at distance 6 to 14 from its points and 2
  // off.
  const auto third = [](double in_plane) { return std::sqrt(in_plane * in_plane + 4); };
  CHECK(place(spheres, {5, 5, third(8)}, points));
  CHECK(place(spheres, {5, 5, third(6.001)}, points));
  CHECK_FALSE(place(spheres, {5, 5, third(5.999)}, points));
  CHECK(place(spheres, {5, 5, third(13.999)}, points));
  CHECK_FALSE(place(spheres, {5, 5, third(14.001)}, points));
  CHECK_FALSE(place(spheres, {5, 5, 1.9}, points));
  CHECK_FALSE(place(spheres, {2.9, 2.9, third(8)}, points));
  points.col(2) << 0, 0, 2;
  CHECK_FALSE(place(spheres, {5, 5, third(4)}, points));
}

TEST_CASE("a plan counts its driving parameters and knows the constraints that it leaves out") {
  const Plan plan = chain(2, 8);
  CHECK(plan.driving_parameters() == 2);
  REQUIRE(plan.removed().size() == 2);
  CHECK(plan.removed()[1] == plan.removed()[0] + 1);
  CHECK(plan.driven_before(0) == 0);
  CHECK(plan.driven_before(3) == 0);
  CHECK(plan.driven_before(4) == 1);
  CHECK(plan.driven_before(8) == 2);
  CHECK(plan.frame().origin == 0);
  CHECK(plan.frame().axis == 1);
  CHECK(plan.frame().plane == -1);
  CHECK(chain(3, 5).frame().plane == 2);
}

TEST_CASE("evaluating from a later instruction equals evaluating all of the plan") {
  RandomNumbers random(2);
  for (const int dimension : {2, 3}) {
    Plan plan = chain(dimension, 9);
    int evaluated = 0;
    for (int sample = 0; sample < 500; ++sample) {
      std::vector<double> lengths(30);
      for (double& length : lengths) length = random.uniform(1.4, 1.8);
      std::vector<double> driven(5);
      for (double& length : driven) length = random.uniform(1, 3);
      const auto radius = [&](const PlanSphere& sphere, int j) {
        return sphere.is_driven() ? driven[j] : lengths[sphere.constraint];
      };
      Eigen::Matrix3Xd before = Eigen::Matrix3Xd::Zero(3, 9);
      if (!evaluate_plan(plan, 0, radius, before)) continue;
      const int changed = random.index(plan.driving_parameters());
      driven[changed] += random.uniform(-0.1, 0.1);
      std::size_t first = 0;
      while (plan.driven_before(first + 1) <= changed) ++first;

      Eigen::Matrix3Xd all = Eigen::Matrix3Xd::Zero(3, 9);
      Eigen::Matrix3Xd later = before;
      const bool possible = evaluate_plan(plan, 0, radius, all);
      CHECK(evaluate_plan(plan, first, radius, later) == possible);
      if (!possible) continue;
      ++evaluated;
      CHECK(later == all);
    }
    CHECK(evaluated >= 20);
  }
}
