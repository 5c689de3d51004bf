/// 5p1L of Hoffmann and Yuan 2000, and random ones.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

constexpr double pi = std::numbers::pi;

/// Distances of all five points (the apex last) to the x-axis, of the four others to the apex and around.
ProblemStatement pyramid_of(const Eigen::Matrix3Xd& points) {
  ProblemStatement problem = samples::problem_of(3, 5, {}, {});
  problem.lines = {"L"};
  const auto add = [&](int a, int b, double length) {
    problem.constraints.push_back({"c", {a, b}, {length, ""}, false});
  };
  for (int p = 0; p < 5; ++p) add(p, 5, points.col(p).tail<2>().norm());
  for (int p = 0; p < 4; ++p) add(4, p, (points.col(p) - points.col(4)).norm());
  for (int p = 0; p < 4; ++p) add(p, (p + 1) % 4, (points.col(p) - points.col((p + 1) % 4)).norm());
  return problem;
}

/// Table 1 of the paper.
Pyramid published() {
  Pyramid pyramid;
  pyramid.apex = 4;
  pyramid.cycle = {0, 1, 2, 3};
  pyramid.radius = {5.12863551744133, 3.4797204504532, 5.12009033478805, 4.48866237372967};
  pyramid.apex_radius = 0.854823450422681;
  pyramid.spoke = {5.40391247291482, 4.92751853999451, 6.556901760918, 5.04776146732994};
  pyramid.side = {2.49916074098941, 9.55687124240852, 9.15, 7.1858882412183};
  return pyramid;
}

/// Points at distance r from the x-axis, `spoke` from the apex and `side` from `hinge`: all around the circle
/// of the latter two, the distance to the axis is sampled and bisected.
std::vector<Eigen::Vector3d> places_by_sampling(double r, double r5, double spoke,
                                                const Eigen::Vector3d& hinge, double side) {
  const Eigen::Vector3d apex(0, 0, r5);
  const Eigen::Vector3d w = (hinge - apex).normalized();
  const double base = (hinge - apex).norm();
  const double s = (spoke * spoke + base * base - side * side) / (2 * base);
  const Eigen::Vector3d u = w.cross(Eigen::Vector3d(0.6, -0.3, 0.2)).normalized();
  const auto place = [&](double angle) {
    const Eigen::Vector3d across = std::cos(angle) * u + std::sin(angle) * u.cross(w);
    return Eigen::Vector3d(apex + s * w + std::sqrt(spoke * spoke - s * s) * across);
  };
  const auto excess = [&](double angle) { return place(angle).tail<2>().norm() - r; };
  constexpr int samples = 20000;
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < samples; ++i) {
    double low = 2 * pi * i / samples, high = 2 * pi * (i + 1) / samples;
    const bool low_inside = excess(low) < 0;
    if ((excess(high) < 0) == low_inside) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      ((excess(middle) < 0) == low_inside ? low : high) = middle;
    }
    result.push_back(place(low));
  }
  return result;
}

/// Those of `points` that are none of `others`.
int missing(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& others) {
  return static_cast<int>(std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return std::none_of(others.begin(), others.end(),
                        [&](const Eigen::Vector3d& q) { return (p - q).norm() <= 1e-8; });
  }));
}

/// The twelve equations but that of d34 hold, to rounding.
bool satisfies_all_but_gap(const Pyramid& p, const PyramidBranch& branch) {
  const Eigen::Vector3d apex(0, 0, p.apex_radius);
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& here = branch.cycle[i];
    worst = std::max(worst, std::abs(here.tail<2>().norm() - p.radius[i]));
    worst = std::max(worst, std::abs((here - apex).norm() - p.spoke[i]));
    if (i != 2) worst = std::max(worst, std::abs((here - branch.cycle[(i + 1) % 4]).norm() - p.side[i]));
  }
  return worst <= 1e-9;
}

}  // namespace

TEST_CASE("a pyramid over a line is recognised under any names and orders") {
  RandomNumbers random(1);
  ProblemStatement problem = pyramid_of(random.points(3, 5, 2));
  const auto pyramid = find_pyramid(Scene(problem));
  REQUIRE(pyramid);
  CHECK(pyramid->apex == 4);
  CHECK(pyramid->cycle == std::array<int, 4>{0, 1, 2, 3});
  std::swap(problem.constraints[0], problem.constraints[12]);
  std::swap(problem.constraints[3].between[0], problem.constraints[3].between[1]);
  for (DistanceConstraint& c : problem.constraints)  // points in the opposite order
    for (int& end : c.between) end = end < 5 ? 4 - end : end;
  const auto other = find_pyramid(Scene(problem));
  REQUIRE(other);
  CHECK(other->apex == 0);
  CHECK(other->cycle == std::array<int, 4>{1, 2, 3, 4});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(other->radius[i] == pyramid->radius[3 - i]);
    CHECK(other->spoke[i] == pyramid->spoke[3 - i]);
    CHECK(other->side[i] == pyramid->side[(6 - i) % 4]);
  }
}

TEST_CASE("what is no pyramid over a line is not taken for one") {
  RandomNumbers random(1);
  const ProblemStatement problem = pyramid_of(random.points(3, 5, 2));
  ProblemStatement fixed = problem;
  fixed.fixed_points = std::vector<std::optional<Eigen::Vector3d>>(5);
  fixed.fixed_points[0] = Eigen::Vector3d::UnitX();
  CHECK_FALSE(find_pyramid(Scene(fixed)));
  ProblemStatement other_graph = problem;
  other_graph.constraints[12].between = {0, 2};  // two triangles and a path instead of a cycle
  CHECK_FALSE(find_pyramid(Scene(other_graph)));
  CHECK_FALSE(find_pyramid(Scene(samples::octahedron())));
}

TEST_CASE("every branch satisfies all equations but one") {
  const Pyramid pyramid = published();
  const PyramidBranches branches(pyramid);
  int count = 0;
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const std::vector<PyramidBranch> here = branches.at(degrees * pi / 180);
    count += static_cast<int>(here.size());
    CHECK(std::all_of(here.begin(), here.end(),
                      [&](const PyramidBranch& branch) { return satisfies_all_but_gap(pyramid, branch); }));
  }
  CHECK(count > 0);
}

TEST_CASE("branches hold every place that sampling finds, and no other, x1 = 0 included") {
  RandomNumbers random(5);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Pyramid p = *find_pyramid(Scene(pyramid_of(random.points(3, 5, 2))));
    // At the second angle p1 lies in the plane x = 0: |(y, z) − (0, r5)| = d1.
    const double sine =
        (p.radius[0] * p.radius[0] + p.apex_radius * p.apex_radius - p.spoke[0] * p.spoke[0]) /
        (2 * p.radius[0] * p.apex_radius);
    for (const double theta : {random.uniform(0, 2 * pi), std::asin(std::clamp(sine, -1.0, 1.0))}) {
      std::vector<PyramidBranch> branches = PyramidBranches(p).at(theta);
      if (branches.empty()) continue;
      ++compared;
      const Eigen::Vector3d p1 = branches.front().cycle[0], p2 = branches.front().cycle[1];
      std::vector<Eigen::Vector3d> thirds, fourths;
      for (const PyramidBranch& branch : branches) {
        if (branch.cycle[0] == p1) fourths.push_back(branch.cycle[3]);
        if (branch.cycle[1] == p2) thirds.push_back(branch.cycle[2]);
      }
      const auto third = places_by_sampling(p.radius[2], p.apex_radius, p.spoke[2], p2, p.side[1]);
      const auto fourth = places_by_sampling(p.radius[3], p.apex_radius, p.spoke[3], p1, p.side[3]);
      CHECK(missing(thirds, third) + missing(third, thirds) == 0);
      CHECK(missing(fourths, fourth) + missing(fourth, fourths) == 0);
    }
  }
  CHECK(compared >= 12);
}

TEST_CASE("a random placement lies on a branch at its own angle") {
  RandomNumbers random(7);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3Xd points = random.points(3, 5, 2);
    const Scene scene(pyramid_of(points));
    Figure figure;
    figure.points = points;
    figure.lines = {LinePosition{}};
    const Pyramid pyramid = *find_pyramid(scene);
    const double unit = std::ldexp(1.0, -scene.unit_exponent());
    const Eigen::Matrix3Xd placed = unit * scene.in_frame(figure, {-1, -1, -1, 0, pyramid.apex}).points;
    const double theta = std::atan2(placed(2, 0), placed(1, 0));
    double nearest = 1;
    for (const PyramidBranch& branch : PyramidBranches(pyramid).at(theta)) {
      double difference = 0;
      for (int p = 0; p < 4; ++p)
        difference = std::max(difference, (branch.cycle[p] - placed.col(p)).cwiseAbs().maxCoeff());
      nearest = std::min(nearest, difference);
    }
    INFO(i);
    CHECK(nearest <= 1e-9);
  }
}

TEST_CASE(
    "the sampled curve is symmetric: mirrored in the plane of the line and the apex, p1 is at 180° − θ") {
  const std::vector<GapSample> curve = sample_gap_curve(published(), 36);
  REQUIRE(!curve.empty());
  const auto gaps_at = [&](double theta) {
    std::vector<double> gaps;
    for (const GapSample& sample : curve)
      if (sample.theta == theta) gaps.push_back(sample.gap);
    std::sort(gaps.begin(), gaps.end());
    return gaps;
  };
  for (const double theta : {0.0, 20.0, 50.0, 80.0}) {
    const std::vector<double> here = gaps_at(theta), there = gaps_at(180 - theta);
    REQUIRE(here.size() == there.size());
    for (std::size_t i = 0; i < here.size(); ++i) CHECK(here[i] == Approx(there[i]).epsilon(1e-9));
  }
}
