/// Bodies that share lines and planes, and directions that elements of two bodies have in common. The numbers are derived
/// by hand: a line that two bodies share may lie either way in the second, so that both ways are counted; a plane has a side.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/tests/elements/checked_counts.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::check_complete;
using samples::check_counts;
using samples::RandomNumbers;

namespace {

/// A figure at random and what is stated of it; points first, then lines, then planes, by their numbers among them.
class Posture {
 public:
  explicit Posture(std::uint64_t seed, int dimension = 3) : random_(seed) { problem_.dimension = dimension; }

  int point() { return add(random_.point(problem_.dimension, 1)); }
  int point_on(int line) {
    const LinePosition& at = figure_.lines[index(line)];
    return add(at.point + random_.uniform(-1, 1) * at.direction);
  }
  int line() {
    const Eigen::Vector3d through = random_.point(problem_.dimension, 1);
    return line_along(through, random_.point(problem_.dimension, 1).normalized());
  }
  int line_along(const Eigen::Vector3d& through, const Eigen::Vector3d& direction) {
    problem_.lines.push_back("L" + std::to_string(problem_.lines.size()));
    figure_.lines.push_back({through, direction});
    return static_cast<int>(figure_.lines.size()) - 1;
  }
  int parallel_line(int line) {
    return line_along(random_.point(problem_.dimension, 1), -figure_.lines[index(line)].direction);
  }
  int plane() { return plane_across(random_.point(3, 1).normalized()); }
  int plane_across(const Eigen::Vector3d& normal) {
    problem_.planes.push_back("h" + std::to_string(problem_.planes.size()));
    figure_.planes.push_back({normal, random_.uniform(-1, 1)});
    return static_cast<int>(figure_.planes.size()) - 1;
  }

  /// Once all elements are there: one that has these, the first where it stands, others in a pose at random.
  Posture& body(const std::vector<int>& points, const std::vector<int>& lines = {},
                const std::vector<int>& planes = {}) {
    RigidBody body{"b" + std::to_string(problem_.bodies.size()), {}};
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    if (!problem_.bodies.empty()) {
      turn = samples::random_turn(problem_.dimension, random_).toRotationMatrix();
      shift = random_.point(problem_.dimension, 1);
    }
    const auto put = [&](int entity, const std::vector<Eigen::Vector3d>& vectors) {
      body.elements.push_back({entity, {}});
      for (const Eigen::Vector3d& vector : vectors)
        for (int axis = 0; axis < problem_.dimension; ++axis)
          body.elements.back().numbers.push_back({vector[axis], ""});
    };
    for (const int i : points) put(i, {turn * figure_.points.col(i) + shift});
    for (const int i : lines) {
      // Either way, and by any of its points.
      const LinePosition& at = figure_.lines[index(i)];
      const Eigen::Vector3d through = at.point + random_.uniform(-1, 1) * at.direction;
      put(problem_.line_entity(i), {turn * through + shift, random_.sign() * (turn * at.direction)});
    }
    for (const int i : planes) {
      const Eigen::Vector3d normal = turn * figure_.planes[index(i)].normal;
      put(problem_.plane_entity(i), {normal});
      body.elements.back().numbers.push_back({figure_.planes[index(i)].offset + normal.dot(shift), ""});
    }
    problem_.bodies.push_back(std::move(body));
    problem_.reference_body = 0;
    return *this;
  }
  Posture& distance(int a, int b) {
    return distance_of(a, b, (figure_.points.col(a) - figure_.points.col(b)).norm());
  }
  Posture& distance_from_line(int a, int line) {
    const LinePosition& at = figure_.lines[index(line)];
    return distance_of(a, problem_.line_entity(line),
                       (figure_.points.col(a) - at.point).cross(at.direction).norm());
  }
  Posture& parallel_lines(int a, int b) {
    return relate("parallel", problem_.line_entity(a), problem_.line_entity(b));
  }
  Posture& parallel_planes(int a, int b) {
    return relate("parallel", problem_.plane_entity(a), problem_.plane_entity(b));
  }
  Posture& line_across(int line, int plane) {
    return relate("perpendicular", problem_.line_entity(line), problem_.plane_entity(plane));
  }

  const ProblemStatement& problem() const { return problem_; }
  const Figure& figure() const { return figure_; }
  const Eigen::Vector3d& direction_of(int line) const { return figure_.lines[index(line)].direction; }
  const Eigen::Vector3d& normal_of(int plane) const { return figure_.planes[index(plane)].normal; }

 private:
  static std::size_t index(int number) { return static_cast<std::size_t>(number); }

  int add(const Eigen::Vector3d& at) {
    problem_.points.push_back("p" + std::to_string(problem_.points.size()));
    figure_.points.conservativeResize(3, figure_.points.cols() + 1);
    figure_.points.rightCols<1>() = at;
    return static_cast<int>(figure_.points.cols()) - 1;
  }
  Posture& distance_of(int a, int b, double length) {
    problem_.constraints.push_back(
        {"d" + std::to_string(problem_.constraints.size()), {a, b}, {length, ""}, false});
    return *this;
  }
  Posture& relate(const std::string& type, int a, int b) {
    problem_.relations.push_back({"r" + std::to_string(problem_.relations.size()), type, {{a}, {b}}});
    return *this;
  }

  RandomNumbers random_;
  ProblemStatement problem_;
  Figure figure_{Eigen::Matrix3Xd(3, 0), {}};
};

Answer check(const Posture& posture, std::size_t count) {
  return check_counts(posture.problem(), posture.figure(), count);
}

std::vector<int> points_of(Posture& posture, int count) {
  std::vector<int> points;
  for (int i = 0; i < count; ++i) points.push_back(posture.point());
  return points;
}

}  // namespace

TEST_CASE("two bodies on a line and two distances: two conics in the angle's plane, 4 each way") {
  // |p − q|² is linear in cos and sin of the angle but for the square of the slide, which the difference of two loses.
  Posture posture(61);
  const int line = posture.line();
  const std::vector<int> p = points_of(posture, 6);
  posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {line});
  check(posture.distance(p[0], p[3]).distance(p[1], p[4]), 8);
}

TEST_CASE("two bodies on a plane and three distances: a planar platform with points at heights, 6") {
  Posture posture(62);
  const int plane = posture.plane();
  const std::vector<int> p = points_of(posture, 6);
  posture.body({p[0], p[1], p[2]}, {}, {plane}).body({p[3], p[4], p[5]}, {}, {plane});
  check(posture.distance(p[0], p[3]).distance(p[1], p[4]).distance(p[2], p[5]), 6);
}

TEST_CASE(
    "a point and a line through it are a hinge either way, 2 · 2; a point and a plane are one with a side, "
    "2") {
  Posture posture(63);
  const std::vector<int> p = points_of(posture, 4);
  SECTION("line") {
    const int line = posture.line(), shared = posture.point_on(line);
    posture.body({p[0], p[1], shared}, {line}).body({p[2], p[3], shared}, {line});
    check(posture.distance(p[0], p[2]), 4);
  }
  SECTION("plane") {
    const int plane = posture.plane(), shared = posture.point();
    posture.body({p[0], p[1], shared}, {}, {plane}).body({p[2], p[3], shared}, {}, {plane});
    check(posture.distance(p[0], p[2]), 2);
  }
}

TEST_CASE("a line and a plane across it are a hinge with a side, 2; two planes a slide, 2") {
  Posture posture(64);
  const std::vector<int> p = points_of(posture, 6);
  SECTION("hinge") {
    const int line = posture.line(), across = posture.plane_across(posture.direction_of(line));
    posture.body({p[0], p[1], p[2]}, {line}, {across}).body({p[3], p[4], p[5]}, {line}, {across});
    check(posture.distance(p[0], p[3]), 2);
  }
  SECTION("slide") {
    const int a = posture.plane(), b = posture.plane();
    posture.body({p[0], p[1], p[2]}, {}, {a, b}).body({p[3], p[4], p[5]}, {}, {a, b});
    check(posture.distance(p[0], p[3]), 2);
  }
}

TEST_CASE("a ring of a hinge, a cylinder and a ball closes in 4 angles, either way") {
  // The ball is as far from the line as in its body, an equation of degree two in cosine and sine of the hinge's angle.
  Posture posture(65);
  const int line = posture.line();
  const std::vector<int> p = points_of(posture, 6);
  posture.body({p[0], p[1], p[2]}).body({p[0], p[1], p[3]}, {line}).body({p[2], p[4], p[5]}, {line});
  check(posture, 8);
}

TEST_CASE(
    "a hinge and three cylinders in a ring: 2 directions of the coupler for each angle, each line either "
    "way") {
  // With both of the coupler's neighbours at rest its direction is where two cones meet; slides are linear.
  Posture posture(66);
  const int a = posture.line(), b = posture.line(), c = posture.line();
  const std::vector<int> p = points_of(posture, 10);
  posture.body({p[0], p[1], p[2]}, {c})
      .body({p[0], p[1], p[3]}, {a})
      .body({p[4], p[5], p[6]}, {a, b})
      .body({p[7], p[8], p[9]}, {b, c});
  posture.distance(p[2], p[3]);
  check_complete(solve(Scene::unchecked(posture.problem()), Polyhedral{.certify = true}), 2 * 2 * 8);
}

TEST_CASE("three bodies on three planes in a ring and three distances, 2 · 2 · 2") {
  // One normal is where two cones meet; the first body then moves on two circles, and the last one along a line.
  Posture posture(67);
  const int a = posture.plane(), b = posture.plane(), c = posture.plane();
  const std::vector<int> p = points_of(posture, 9);
  posture.body({p[0], p[1], p[2]}, {}, {a, c})
      .body({p[3], p[4], p[5]}, {}, {a, b})
      .body({p[6], p[7], p[8]}, {}, {b, c});
  check(posture.distance(p[0], p[3]).distance(p[1], p[4]).distance(p[2], p[6]), 8);
}

TEST_CASE("three bodies on one line and two distances between two and two, 8 · 8") {
  Posture posture(68);
  const int line = posture.line();
  const std::vector<int> p = points_of(posture, 9);
  posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {line}).body({p[6], p[7], p[8]}, {line});
  posture.distance(p[0], p[3]).distance(p[1], p[4]).distance(p[3], p[6]);
  check(posture.distance(p[4], p[7]), 64);
}

TEST_CASE(
    "in the plane a body slides along a line to two places at a distance, either way; so does a "
    "slider-crank") {
  Posture posture(69, 2);
  const int line = posture.line();
  SECTION("slider") {
    const std::vector<int> p = points_of(posture, 4);
    posture.body({p[0], p[1]}, {line}).body({p[2], p[3]}, {line});
    check(posture.distance(p[0], p[2]), 4);
  }
  SECTION("slider-crank") {
    const std::vector<int> p = points_of(posture, 5);
    posture.body({p[0], p[1]}, {line}).body({p[0], p[2]}).body({p[2], p[3]}).body({p[3], p[4]}, {line});
    check(posture.distance(p[1], p[2]), 2 * 2 * 2);
  }
}

TEST_CASE(
    "directions of two bodies are one in two ways, and a point at three distances and a turn in two each") {
  Posture posture(70);
  const std::vector<int> p = points_of(posture, 6);
  const auto check_held = [&](std::size_t count) {
    posture.distance(p[0], p[3]).distance(p[1], p[3]).distance(p[2], p[3]).distance(p[0], p[4]);
    check(posture, count);
  };
  SECTION("planes") {
    const int plane = posture.plane(), other = posture.plane_across(-posture.normal_of(plane));
    posture.body({p[0], p[1], p[2]}, {}, {plane}).body({p[3], p[4], p[5]}, {}, {other});
    posture.parallel_planes(plane, other);
    check_held(8);
  }
  const int line = posture.line();
  SECTION("a line across a plane") {
    const int plane = posture.plane_across(posture.direction_of(line));
    posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {}, {plane});
    posture.line_across(line, plane);
    check_held(8);
  }
  const int other = posture.parallel_line(line);
  SECTION("lines") {
    posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {other});
    posture.parallel_lines(line, other);
    check_held(8);
  }
  SECTION("lines that both are parallel to a third one, which two points hold in 2 ways") {
    const int third = posture.parallel_line(line);
    posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {other});
    posture.parallel_lines(line, third).parallel_lines(other, third);
    posture.distance_from_line(p[0], third).distance_from_line(p[1], third);
    check_held(16);
  }
}

TEST_CASE(
    "a body on a given line or plane through the origin, 8 and 6; given points that tell its pose place the "
    "others") {
  Problem problem(3);
  const Placed a1("a1", {0.1, 0.2, 0.9}), a2("a2", {1, 0.3, 0.2}), a3("a3", {0.2, 0.8, 0.1});
  const auto check_all = [&](std::size_t count) {
    const Scene scene(problem);
    const Answer loops = solve(scene, Monodromy{.certify = true});
    check_complete(loops, count);
    check_complete(solve(scene, Polyhedral{.certify = true}), count);
    const Answer newton = solve(scene, NewtonMultistart{.certify = true});
    CHECK(newton.failed_checks.empty());
    CHECK(newton.solutions.size() == loops.proofs->real);
  };
  SECTION("line") {
    problem.body("b", {a1, a2, a3, {"L", {0, 0.1, 0.3}, {1, 0.2, 0.1}}});
    problem.points("q", "r").fix("L", {0, 0, 0}, {0, 0, 1}).fix("q", {1, 0, 0}).fix("r", {0, 1, 0.3});
    problem.distance("q", "a1", 1.1).distance("r", "a2", 0.9);
    check_all(8);
  }
  SECTION("plane") {
    problem.body("b", {a1, a2, a3, {"E", {0.1, 0.2, 1}, 0.1}});
    problem.points("q", "r", "s").fix("E", {0, 0, 1}, 0);
    problem.fix("q", {1, 0, 0}).fix("r", {0, 1, 0.3}).fix("s", {-1, 0.2, 0.1});
    problem.distance("q", "a1", 1.1).distance("r", "a2", 0.9).distance("s", "a3", 1.2);
    check_all(6);
  }
  SECTION("points") {
    problem.body("b", {{"b1", {0, 0, 0}}, {"b2", {1, 0, 0}}, {"b3", {0, 1, 0}}, {"b4", {0.3, 0.2, 0.5}}});
    problem.points("q").fix("b1", {0.5, 0, 0}).fix("b2", {0.5, 1, 0}).fix("b3", {0.5, 0, 1});
    problem.distance("q", "b4", 1.1).distance("q", "b1", 0.9).distance("q", "b2", 1.2);
    check_all(2);
  }
}

TEST_CASE("bodies that share what leaves them a slide along lines are named") {
  Posture posture(72);
  const int line = posture.line(), other = posture.parallel_line(line);
  const std::vector<int> p = points_of(posture, 6);
  posture.body({p[0], p[1], p[2]}, {line, other}).body({p[3], p[4], p[5]}, {line, other});
  const auto reason = why_no_system(Scene::unchecked(posture.problem()));
  REQUIRE(reason);
  CHECK(*reason == "there are no equations yet for bodies that share L0 and L1, as 'b0' and 'b1' do");
}

TEST_CASE("what Newton's method finds of bodies on a line are their real postures") {
  Posture posture(71);
  const int line = posture.line();
  const std::vector<int> p = points_of(posture, 6);
  posture.body({p[0], p[1], p[2]}, {line}).body({p[3], p[4], p[5]}, {line});
  const Answer loops = check(posture.distance(p[0], p[3]).distance(p[1], p[4]), 8);
  const Answer newton =
      solve(Scene::unchecked(posture.problem()), NewtonMultistart{.seed = 3, .certify = true});
  CHECK(newton.status == RunStatus::complete);
  CHECK(newton.failed_checks.empty());
  CHECK(newton.solutions.size() == loops.proofs->real);
}
