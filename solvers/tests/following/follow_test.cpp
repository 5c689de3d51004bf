/// Figures that move with changing values, against closed forms and against all of S.

#include "solvers/solving/follow.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "solvers/solving/solve.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"

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

Figure representative(const Scene& scene, const Figure& figure) {
  return scene.in_file_unit(scene.representative(scene.in_scene_unit(figure)));
}

/// Beyond a fold solutions meet all values, and S, which is closed, meets as many rising as falling. How many there are.
std::size_t check_beyond(const RandomChange& change, const Followed& folded) {
  REQUIRE(folded.beyond);
  const Answer& answer = *folded.beyond;
  if (answer.status != RunStatus::complete) return 0;
  int balance = 0;
  for (const AssessedCrossing& crossing : answer.crossings) balance += crossing.direction;
  CHECK(balance == 0);
  const ProblemStatement problem = with_changes(change.scene.problem(), change.from, change.changes);
  for (const AssessedSolution& solution : answer.solutions)
    for (const DistanceConstraint& constraint : problem.constraints) {
      const auto [a, b] = constraint.between;
      const Figure figure = solution.placement();
      const double length = (figure.points.col(a) - figure.points.col(b)).norm();
      CHECK(length == Approx(constraint.length()).epsilon(1e-9));
    }
  return answer.solutions.size();
}

/// The first solution that full-space meets on S with no length bent.
Figure first_on_path(const RandomChange& change) {
  ProblemStatement straight = with_changes(change.scene.problem(), change.from, change.changes);
  straight.interpolation.bends.emplace();
  const Answer answer = solve(Scene::unchecked(straight), "full-space", {{"until", "first"}});
  REQUIRE(answer.crossings.size() == 1);
  return answer.solutions.front().placement();
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
    if (settings.arc.prove) CHECK(moved.error.value() < 1e-13);
  }
}

TEST_CASE("where positions are given the corner follows too, and folds") {
  Problem p(2);
  p.points("a", "b", "c").distance("b", "c", 4).distance("c", "a", 5);
  p.fix("a", {0, 0}).fix("b", {3, 0});
  p.sketch("a", {0, 0}).sketch("b", {3, 0}).sketch("c", {3, 4});
  for (const FollowSettings& settings : both) {
    const Followed moved = follow(p, {{"a2", "6.5"}}, settings);
    REQUIRE(moved.end == ArcEnd::reached);
    CHECK(moved.proven == settings.arc.prove);
    CHECK((moved.figure.points.col(2) - corner(6.5)).norm() < 1e-13);
    const Followed folded = follow(p, {{"a2", 8}}, settings);
    REQUIRE(folded.end == ArcEnd::folds);
    CHECK(folded.proven == settings.arc.prove);
    CHECK(folded.values[0].low <= 7);
    CHECK(folded.values[0].high >= 7);
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
      CHECK(largest_difference(representative(change.scene, there.figure), first_on_path(change)) < 1e-9);
      const Followed back = follow(Scene::unchecked(change.scene.problem()), there.figure,
                                   random_change(change.scene.problem(), random, 0).changes);
      REQUIRE(back.end == ArcEnd::reached);
      CHECK(largest_difference(back.figure, change.scene.in_frame(change.from)) < 1e-9);
    }
  CHECK(reached > 0);
  CHECK(folds > 0);
}

TEST_CASE("beyond a fold of an octahedron there may be solutions") {
  RandomNumbers random(5);
  ProblemStatement problem = samples::octahedron();
  const Answer known = solve(Scene(problem), "full-space");
  REQUIRE(known.solutions.size() == 4);  // Imbach, Mathis, Schreck 2016, Table 1
  std::size_t beyond = 0;
  for (std::size_t round = 0; round < 40; ++round) {
    problem.sketch = known.solutions[round % 4].placement();
    const RandomChange change = random_change(problem, random, 0.2);
    const Followed moved = follow(change.scene, change.from, change.changes);
    CHECK(moved.proven);
    if (moved.end == ArcEnd::folds) beyond += check_beyond(change, moved);
  }
  CHECK(beyond > 0);
}

TEST_CASE("cosines travel, and fold where a ray touches a circle") {
  constexpr double degree = std::numbers::pi / 180;
  // c on a ray from o, half as far from a as o is: the ray meets that circle up to 30 degrees.
  Problem ray(2);
  ray.points("o", "a", "c").distance("o", "a", 1).distance("a", "c", "0.5");
  ray.angle({"o", "a"}, {"o", "c"}, 20);
  const auto on_ray = [](double degrees) {
    const double angle = degrees * degree, sine = std::sin(angle);
    const double far = std::cos(angle) + std::sqrt(0.25 - sine * sine);
    return Eigen::Vector3d(far * std::cos(angle), far * sine, 0);
  };
  const Eigen::Vector3d c = on_ray(20);
  ray.sketch("o", {0, 0}).sketch("a", {1, 0}).sketch("c", {c.x(), c.y()});
  for (const FollowSettings& settings : both) {
    const Followed moved = follow(ray, {{"a3", "29.5"}}, settings);
    INFO(moved.reason << moved.why_unproven);
    REQUIRE(moved.end == ArcEnd::reached);
    CHECK(moved.proven == settings.arc.prove);
    CHECK((moved.figure.points.col(2) - on_ray(29.5)).norm() < 1e-12);
    if (settings.arc.prove) CHECK(moved.error.value() < 1e-9);
    const Followed beyond = follow(ray, {{"a3", 40}}, settings);
    REQUIRE(beyond.end == ArcEnd::folds);
    CHECK(beyond.proven == settings.arc.prove);
    REQUIRE(beyond.values.size() == 1);
    CHECK(beyond.values[0].low <= std::sqrt(0.75));
    CHECK(beyond.values[0].high >= std::sqrt(0.75));
    CHECK(beyond.values[0].high - beyond.values[0].low < 1e-8);
  }
}

TEST_CASE("platforms move there and back") {
  RandomNumbers random(11);
  int reached = 0;
  for (int dimension : {2, 3})
    for (int round = 0; round < 3; ++round) {
      INFO(dimension << " " << round);
      ProblemStatement problem = samples::sketched(samples::random_platform(dimension, random), random);
      const Scene scene = Scene::unchecked(problem);
      const Answer known = solve(scene, "full-space");
      if (known.solutions.empty()) continue;
      const Figure from = known.solutions.front().placement();
      ChangedValues changes, values;
      for (const DistanceConstraint& constraint : problem.constraints) {
        const double length = constraint.length();
        changes.push_back({constraint.id, length * (1 + 0.01 * random.uniform(-1, 1))});
        values.push_back({constraint.id, length});
      }
      const Followed there = follow(scene, from, changes);
      INFO(there.reason << there.why_unproven);
      CHECK(there.proven);
      if (there.end != ArcEnd::reached) continue;
      CHECK(there.error.value() < 1e-6 * scene.size());
      const Followed back = follow(scene, there.figure, values);
      REQUIRE(back.end == ArcEnd::reached);
      CHECK(largest_difference(back.figure, from) < 1e-8);
      ++reached;
    }
  CHECK(reached > 0);
}

TEST_CASE("what cannot be a value is refused with one message") {
  const Scene scene = triangle();
  CHECK_THROWS_WITH(follow(scene, {{"a9", 1}}), Catch::Contains("a9") && Catch::Contains("a1"));
  CHECK_THROWS_WITH(follow(scene, {{"a3", -1}}), Catch::Contains("> 0"));
  CHECK_THROWS_AS(follow(scene, {{"a3", "long"}}), UserError);
}
