/// S of general scenes against monodromy, against another way to track it, and against geometry.

#include "solvers/tracking/general_path.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/general_figures.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/sanitized.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"
#include "solvers/tests/tracking/slow_general_path.hpp"
#include "solvers/tracking/real_equations.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

/// The coordinates that the frame of three points makes zero are.
ProblemStatement with_sketch_in_frame(ProblemStatement problem) {
  const Scene scene = Scene::unchecked(problem);
  problem.sketch = scene.in_file_unit(*scene.sketch());
  return problem;
}

/// Each figure is one real solution of the answer.
void check_listed_once(const Scene& scene, const std::vector<Figure>& figures, const Answer& answer) {
  for (const Figure& figure : figures)
    CHECK(std::ranges::count_if(answer.solutions, [&](const AssessedSolution& one) {
            return one.is_real() && are_alike(scene, figure, one.figure);
          }) == 1);
}

double distance_from_line(const Eigen::Vector3d& p, const Eigen::Vector3d& foot,
                          const Eigen::Vector3d& direction) {
  return (p - foot).cross(direction).norm();
}

/// A point at distances from a line, a plane and a point that are given; two such points are the target and the sketch.
Problem beside_given_elements(RandomNumbers& random) {
  const Eigen::Vector3d target = random.point(3, 1), sketch = random.point(3, 1), q = random.point(3, 1),
                        foot = random.point(3, 1), along = random.point(3, 1).normalized(),
                        normal = random.point(3, 1).normalized();
  const double offset = random.uniform(-0.5, 0.5);
  Problem problem(3);
  problem.points("p", "q").lines("L").planes("E");
  problem.fix("q", {q[0], q[1], q[2]}).fix("L", {foot[0], foot[1], foot[2]}, {along[0], along[1], along[2]});
  problem.fix("E", {normal[0], normal[1], normal[2]}, offset);
  problem.distance("p", "q", (target - q).norm()).distance("p", "L", distance_from_line(target, foot, along));
  problem.distance("p", "E", normal.dot(target) - offset);
  return problem.sketch("p", {sketch[0], sketch[1], sketch[2]});
}

/// In the plane, a point at distances from a line and a point that are given.
Problem beside_given_elements_in_the_plane(RandomNumbers& random) {
  const Eigen::Vector3d target = random.point(2, 1), sketch = random.point(2, 1), q = random.point(2, 1),
                        foot = random.point(2, 1), along = random.point(2, 1).normalized();
  Problem problem(2);
  problem.points("p", "q")
      .lines("L")
      .fix("q", {q[0], q[1]})
      .fix("L", {foot[0], foot[1]}, {along[0], along[1]});
  problem.distance("p", "q", (target - q).norm()).distance("p", "L", distance_from_line(target, foot, along));
  return problem.sketch("p", {sketch[0], sketch[1]});
}

/// A line at distances from four given points; the target and the sketch are lines near each other.
Problem tangent(RandomNumbers& random) {
  const Eigen::Vector3d foot = random.point(3, 1), along = random.point(3, 1),
                        near = foot + random.point(3, 0.3), near_along = along + random.point(3, 0.3);
  Problem problem(3);
  problem.lines("L");
  for (const std::string name : {"a", "b", "c", "d"}) {
    const Eigen::Vector3d p = random.point(3, 1);
    problem.points(name).fix(name, {p[0], p[1], p[2]}).sketch(name, {p[0], p[1], p[2]});
    problem.distance(name, "L", distance_from_line(p, foot, along.normalized()));
  }
  return problem.sketch("L", {near[0], near[1], near[2]}, {near_along[0], near_along[1], near_along[2]});
}

/// A tetrahedron and a line at distances from its corners, which the program puts on an axis.
Problem beside_tetrahedron(RandomNumbers& random) {
  const Eigen::Vector3d foot = random.point(3, 1), along = random.point(3, 1),
                        near = foot + random.point(3, 0.3), near_along = along + random.point(3, 0.3);
  Problem problem(3);
  problem.lines("L");
  std::vector<std::pair<std::string, Eigen::Vector3d>> corners;
  for (const std::string name : {"a", "b", "c", "d"}) {
    const Eigen::Vector3d p = random.point(3, 1), drawn = p + random.point(3, 0.1);
    problem.points(name).sketch(name, {drawn[0], drawn[1], drawn[2]});
    problem.distance(name, "L", distance_from_line(p, foot, along.normalized()));
    for (const auto& [other, q] : corners) problem.distance(other, name, (p - q).norm());
    corners.emplace_back(name, p);
  }
  return problem.sketch("L", {near[0], near[1], near[2]}, {near_along[0], near_along[1], near_along[2]});
}

/// What S meets, which closes by proof and with the same crossings.
std::vector<Figure> met_on_closed(const Scene& scene) {
  const Answer fast = followed(scene.problem()), proven = followed(scene.problem(), {{"mode", "certified"}});
  INFO(fast.reason << "; " << proven.reason);
  CHECK(fast.status == RunStatus::complete);
  REQUIRE(proven.ends.size() == 1);
  CHECK(proven.ends[0].end == PathRecord::End::closed);
  CHECK(proven.ends[0].proven);
  check_same_crossings(scene, crossed(fast), crossed(proven));
  return crossed(fast);
}

}  // namespace

TEST_CASE("S of a free line closes, proven, and is the same in a plan's parameters") {
  std::size_t met = 0;
  for (int seed = 5; seed < 5 + repetitions(8); ++seed) {
    RandomNumbers random(static_cast<std::uint64_t>(seed));
    const Scene scene(beside_tetrahedron(random));
    REQUIRE(scene.reference().line == 0);
    const Answer planned = solve(scene, "rcp");
    CAPTURE(seed, planned.reason);
    const std::vector<Figure> on_path = met_on_closed(scene);
    CHECK(planned.status == RunStatus::complete);
    check_same_crossings(scene, on_path, crossed(planned));
    check_listed_once(scene, on_path, solve(scene, "polyhedral"));
    met += on_path.size();
  }
  CHECK(met >= 2);
}

TEST_CASE("S of a line beside given points closes, proven, and meets common tangents") {
  std::size_t met = 0;
  for (int seed = 1; seed <= repetitions(12); ++seed) {
    RandomNumbers random(static_cast<std::uint64_t>(seed));
    const Scene scene(tangent(random));
    CAPTURE(seed);
    const std::vector<Figure> on_path = met_on_closed(scene);
    check_listed_once(scene, on_path, solve(scene, "sphere-tangents"));
    met += on_path.size();
  }
  CHECK(met >= 2);
}

// Where the distance from a line goes through 0 on the way, the sides of the line cross: a singular point of S.
TEST_CASE("S of points beside given lines and planes meets solutions that monodromy finds") {
  std::size_t met = 0;
  int complete = 0;
  for (int seed = 1; seed <= repetitions(12); ++seed) {
    RandomNumbers random(static_cast<std::uint64_t>(seed));
    for (const Problem& problem :
         {beside_given_elements(random), beside_given_elements_in_the_plane(random)}) {
      const Scene scene(problem);
      const Answer on_path = followed(scene.problem()), all = solve(scene, "monodromy");
      CAPTURE(seed, scene.dimension(), on_path.reason);
      const bool is_complete = on_path.status == RunStatus::complete;
      const auto is_said = [&](const char* cause) { return on_path.reason.find(cause) != std::string::npos; };
      CHECK((is_complete || is_said("singular") || is_said("a length vanishes")));
      complete += is_complete;
      CHECK(all.status == RunStatus::complete);
      CHECK(on_path.failed_checks.empty());
      check_listed_once(scene, crossed(on_path), all);
      met += on_path.crossings.size();
    }
  }
  CHECK(met >= 2);
  CHECK(complete > repetitions(12));  // of twice as many
}

TEST_CASE("S of a general scene is closed, and meets solutions that monodromy finds") {
  std::size_t met = 0;
  for (const std::uint64_t seed : {21U, 22U, 23U})
    for (const ProblemStatement& problem : sample_scenes(seed)) {
      const Answer on_path = followed(problem);
      CAPTURE(name_of(problem), seed, on_path.reason);
      CHECK(on_path.status == RunStatus::complete);
      CHECK(on_path.failed_checks.empty());
      REQUIRE(on_path.ends.size() == 1);
      CHECK(on_path.ends[0].end == PathRecord::End::closed);
      CHECK(on_path.crossings.size() % 2 == 0);
      const Scene scene = Scene::unchecked(problem);
      const Answer all = solve(scene, "monodromy");
      check_listed_once(scene, crossed(on_path), all);
      met += on_path.crossings.size();
    }
  CHECK(met >= 10);
}

TEST_CASE("S of a general scene does not depend on orders, tolerances and steps") {
  for (const ProblemStatement& problem : sample_scenes(24)) {
    const std::vector<Figure> expected = crossed(followed(problem));
    for (const OptionMap& options :
         {OptionMap{{"order", "20"}}, OptionMap{{"tolerance", "1e-11"}}, OptionMap{{"step_max", "0.05"}}}) {
      CAPTURE(name_of(problem), options.begin()->first);
      check_same_crossings(Scene::unchecked(problem), crossed(followed(problem, options)), expected);
    }
    std::vector<Figure> backward = crossed(followed(problem, {{"orientation", "backward"}}));
    std::ranges::reverse(backward);
    CAPTURE(name_of(problem));
    check_same_crossings(Scene::unchecked(problem), backward, expected);
  }
}

TEST_CASE("tiny steps by geometry meet the same solutions of general scenes in the same order") {
  for (const std::uint64_t seed : {25U})
    for (const ProblemStatement& random : sample_scenes(seed)) {
      const ProblemStatement problem = random.bodies.empty() ? with_sketch_in_frame(random) : random;
      const Scene scene = Scene::unchecked(problem);
      const Answer answer = followed(problem);
      std::vector<Figure> expected = crossed(answer);
      if (expected.empty()) continue;
      expected.push_back(expected.front());  // once more round
      const auto slow = SlowPath(problem).crossings(expected.size());
      CAPTURE(name_of(problem), seed);
      std::vector<Figure> met;
      for (const auto& [figure, direction] : slow) met.push_back(scene.in_scene_unit(figure));
      check_same_crossings(scene, met, expected);
      for (std::size_t i = 0; i < answer.crossings.size(); ++i)
        CHECK(slow[i].second == answer.crossings[i].direction);
    }
}

TEST_CASE("names, orders and units of a general scene do not change S") {
  for (const ProblemStatement& problem : sample_scenes(27)) {
    CAPTURE(name_of(problem));
    check_same_crossings(Scene::unchecked(problem), crossed(followed(renamed_and_scaled(problem))),
                         crossed(followed(problem)));
  }
}

TEST_CASE("a sketch is moved to where the constraints without a value hold") {
  ProblemStatement problem = corner_of_lines(60, 40, 80);
  problem.sketch->points.col(2) += Eigen::Vector3d(2e-4, -3e-4, 0);
  const Scene scene = Scene::unchecked(problem);
  const SceneSystem system(scene);
  const auto start = sketched_unknowns(scene, system);
  REQUIRE(start);
  CHECK(start->moved > 1e-5);
  CHECK(start->moved < 1e-3);
  const RealEquations equations = real_equations(system.equations());
  const Eigen::VectorXd excess = equations.sums(start->x) - equations.given;
  for (std::size_t e = 0; e < system.value_of().size(); ++e)
    if (system.value_of()[e] == no_value) CHECK(std::abs(excess[static_cast<Eigen::Index>(e)]) <= 1e-14);
}

TEST_CASE("where a point goes to infinity on both sides S ends there, and is complete") {
  // L turns about o from 60° as far as 80° − 180° and 80°, where it is parallel to M.
  struct Sample {
    double of_l;
    std::size_t solutions;
  };
  for (const auto& [of_l, solutions] : {Sample{40, 2}, Sample{79, 2}, Sample{85, 1}}) {
    const Answer answer = followed(corner_of_lines(60, of_l, 80));
    CAPTURE(of_l, answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    REQUIRE(answer.ends.size() == 1);
    CHECK(answer.ends[0].end == PathRecord::End::at_infinity);
    CHECK(answer.solutions.size() == solutions);
  }
}

TEST_CASE("a crossing at which a segment points the other way is met, and not as stated") {
  ProblemStatement problem = samples::point_at_an_angle(50);
  problem.sketch = Figure{Eigen::Matrix3Xd::Zero(3, 4), {}};
  problem.sketch->points.col(1) << 1, 0, 0;
  problem.sketch->points.col(2) << 0.5, std::sqrt(0.75), 0;
  problem.sketch->points.col(3) << 0.5, 0.6, 0;
  const Answer answer = followed(problem);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.claim == Claim::on_path);
  CHECK(answer.failed_checks.empty());
  REQUIRE(answer.solutions.size() == 2);
  CHECK(answer.solutions[0].is_as_stated());
  CHECK(answer.solutions[1].signs == SignVerdict{Standing::not_as_stated, {0}});
  CHECK(answer.counts.on_path == 1U);
  CHECK(answer.counts.not_as_stated == 1U);
}

TEST_CASE("Newton's method from a general sketch ends at a solution or says that it does not") {
  int ended = 0;
  for (const std::uint64_t seed : {28U, 29U, 30U})
    for (const ProblemStatement& problem : sample_scenes(seed)) {
      const Answer answer = followed(problem, {{"mode", "newton"}});
      CHECK(answer.failed_checks.empty());
      if (answer.status == RunStatus::complete)
        ended += answer.solutions.size() == 1;
      else
        CHECK(answer.reason == "Newton's method from the sketch does not settle");
    }
  CHECK(ended > 0);
}

TEST_CASE("what full-space cannot do with a general scene it says") {
  RandomNumbers random(31);
  ProblemStatement problem = sketched(samples::random_octahedral(1, random), random);
  for (const OptionMap& options : {OptionMap{{"mode", "paper"}}, OptionMap{{"jumps", "named"}}}) {
    const Answer answer = followed(problem, options);
    CHECK(answer.status == RunStatus::unsupported);
    CHECK_THAT(answer.reason, Catch::Contains("distances between points"));
  }
  problem.sketch.reset();
  CHECK_THAT(followed(problem).reason, Catch::Contains("sketch"));
}
