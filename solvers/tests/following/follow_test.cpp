/// Figures that move with changing values, against closed forms and against all of S.

#include "solvers/solving/follow.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Sides 3 and 4 with a right angle between them, c counterclockwise of a–b.
Problem triangle() {
  Problem p(2);
  p.points("a", "b", "c").distance("a", "b", 3).distance("b", "c", 4).distance("c", "a", 5);
  p.sketch("a", {0, 0}).sketch("b", {3, 0}).sketch("c", {3, 4});
  return p;
}

/// Where c is at a distance from a and 4 from b, by the law of cosines.
Eigen::Vector3d corner(double distance) {
  const double x = (9 + distance * distance - 16) / 6;
  return {x, std::sqrt(distance * distance - x * x), 0};
}

FollowSettings without_proof() {
  FollowSettings settings;
  settings.arc.prove = false;
  return settings;
}

const FollowSettings both[] = {FollowSettings(), without_proof()};

double largest_difference(const Figure& a, const Figure& b) {
  return (a.points - b.points).cwiseAbs().maxCoeff();
}

/// The figure of a random solution's lengths, each then changed by up to this part.
struct RandomChange {
  Scene scene;
  Figure from;
  ChangedValues changes;
};

RandomChange random_change(ProblemStatement problem, RandomNumbers& random, double part) {
  const Scene sketched = Scene::unchecked(problem);
  const Figure from = *problem.sketch;
  ChangedValues changes;
  for (int i = 0; i < sketched.constraint_count(); ++i) {
    const double length =
        std::ldexp(sketched.length_paths()[static_cast<std::size_t>(i)].at_sketch, sketched.unit_exponent());
    DistanceConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
    constraint.is_squared = false;
    changes.push_back({constraint.id, length * (1 + part * random.uniform(-1, 1))});
  }
  return {Scene::unchecked(std::move(problem)), from, changes};
}

}  // namespace

TEST_CASE("a corner of a triangle follows its side") {
  for (const FollowSettings& settings : both) {
    const Followed moved = follow(triangle(), {{"a3", "6.5"}}, settings);
    REQUIRE(moved.end == ArcEnd::reached);
    CHECK(moved.proven == settings.arc.prove);
    const double error = (moved.figure.points.col(2) - corner(6.5)).norm();
    CHECK(error < 1e-14);
    if (settings.arc.prove) CHECK(error <= moved.error.value() + 1e-15);
    if (settings.arc.prove) CHECK(moved.error.value() < 1e-11);
  }
}

TEST_CASE("a triangle that becomes flat folds where its sides add up") {
  for (const FollowSettings& settings : both) {
    const Followed moved = follow(triangle(), {{"a3", 8}}, settings);
    REQUIRE(moved.end == ArcEnd::folds);
    CHECK(moved.proven == settings.arc.prove);
    CHECK(moved.fold.low <= 2.0 / 3);
    CHECK(moved.fold.high >= 2.0 / 3);
    REQUIRE(moved.values.size() == 1);
    CHECK(moved.values[0].low <= 7);
    CHECK(moved.values[0].high >= 7);
    CHECK(moved.values[0].high - moved.values[0].low < 1e-9);
    CHECK((moved.figure.points.col(2) - Eigen::Vector3d(7, 0, 0)).norm() < 1e-5);
    REQUIRE(moved.beyond);
    CHECK(moved.beyond->status == RunStatus::complete);
    CHECK(moved.beyond->solutions.empty());
  }
}

TEST_CASE("values just this side of a fold are reached, and just beyond it are not") {
  for (const FollowSettings& settings : both) {
    CHECK(follow(triangle(), {{"a3", "6.999999"}}, settings).end == ArcEnd::reached);
    CHECK(follow(triangle(), {{"a3", "7.000001"}}, settings).end == ArcEnd::folds);
    CHECK(follow(triangle(), {{"a3", 7}}, settings).end == ArcEnd::undecided);
  }
}

TEST_CASE("a figure whose values do not change stays where it is") {
  for (const FollowSettings& settings : both) {
    const Followed moved = follow(triangle(), {}, settings);
    REQUIRE(moved.end == ArcEnd::reached);
    CHECK(moved.proven == settings.arc.prove);
    CHECK((moved.figure.points.col(2) - Eigen::Vector3d(3, 4, 0)).norm() < 1e-14);
  }
}

TEST_CASE("along a polyline every vertex is reached up to the first fold") {
  const Scene scene = triangle();
  const std::vector<Followed> legs = follow_polyline(
      scene, *scene.problem().sketch, {{{"a3", 6}}, {{"a3", "4.5"}}, {{"a3", 9}}, {{"a3", 5}}});
  REQUIRE(legs.size() == 3);
  CHECK((legs[0].figure.points.col(2) - corner(6)).norm() < 1e-14);
  CHECK((legs[1].figure.points.col(2) - corner(4.5)).norm() < 1e-14);
  CHECK(legs[2].end == ArcEnd::folds);
  CHECK(legs[2].values[0].low <= 7);
  CHECK(legs[2].values[0].high >= 7);
}

TEST_CASE("random figures move there and back, and where S leads first") {
  RandomNumbers random(7);
  int reached = 0, folds = 0;
  for (int dimension : {2, 3})
    for (int round = 0; round < 12; ++round) {
      ProblemStatement problem = samples::random_problem(dimension, 6, random);
      const RandomChange change = random_change(std::move(problem), random, 0.1);
      INFO(dimension << " " << round);
      const Followed there = follow(change.scene, change.from, change.changes);
      const Followed fast = follow(change.scene, change.from, change.changes, without_proof());
      CHECK(there.proven);
      REQUIRE(there.end == fast.end);
      CHECK(there.figure.points.cols() == change.from.points.cols());
      if (there.end == ArcEnd::folds) {
        ++folds;
        CHECK(there.fold.low <= fast.fold.high);
        CHECK(fast.fold.low <= there.fold.high);
        continue;
      }
      ++reached;
      CHECK(largest_difference(there.figure, fast.figure) < 1e-9);
      const Followed back = follow(Scene::unchecked(change.scene.problem()), there.figure,
                                   random_change(change.scene.problem(), random, 0).changes);
      REQUIRE(back.end == ArcEnd::reached);
      CHECK(largest_difference(back.figure, change.scene.in_frame(change.from)) < 1e-9);
    }
  CHECK(reached > 0);
  CHECK(folds > 0);
}

TEST_CASE("what cannot be a value is refused with one message") {
  const Scene scene = triangle();
  CHECK_THROWS_WITH(follow(scene, {{"a9", 1}}), Catch::Contains("a9") && Catch::Contains("a1"));
  CHECK_THROWS_WITH(follow(scene, {{"a3", -1}}), Catch::Contains("> 0"));
  CHECK_THROWS_AS(follow(scene, {{"a3", "long"}}), UserError);
}
