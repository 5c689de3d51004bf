/// Bodies that are hinged to each other. Six in a ring close in 16 ways: E. J. F. Primrose, On the input-output equation
/// of the general 7R-mechanism, Mech. Mach. Theory 21 (1986); H. Y. Lee, C. G. Liang, Displacement analysis of the general
/// spatial 7-link 7R mechanism, Mech. Mach. Theory 23 (1988). In 8 where three axes that follow each other meet in a point
/// or are parallel: D. L. Pieper, The kinematics of manipulators under computer control, 1968.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/elements/general_structure.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/tests/elements/checked_counts.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::bodies_of;
using samples::check_complete;
using samples::check_counts;
using samples::classes_of;
using samples::RandomNumbers;
using samples::ring_of;

namespace {

Figure in_unit(const Scene& scene, const Eigen::Matrix3Xd& points) {
  Figure figure;
  figure.points = points;
  return scene.in_scene_unit(figure);
}

Answer check_counts(const ProblemStatement& problem, const Eigen::Matrix3Xd& points, std::size_t count,
                    std::uint64_t seed = 1) {
  Figure figure;
  figure.points = points;
  return samples::check_counts(problem, figure, count, seed);
}

void add_distance(int a, int b, const Eigen::Matrix3Xd& points, ProblemStatement& problem) {
  problem.constraints.push_back({"d" + std::to_string(problem.constraints.size()),
                                 {a, b},
                                 {(points.col(a) - points.col(b)).norm(), ""},
                                 false});
}

}  // namespace

TEST_CASE("six bodies in a ring, each hinged to the next, have 16 postures") {
  RandomNumbers random(41);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Eigen::Matrix3Xd points = random.points(3, 12, 1);
    const Answer answer = check_counts(ring_of(points, random), points, 16, seed);
    CHECK(answer.proofs->are_complete());
    CHECK(answer.proofs->generic == 16U);
  }
}

TEST_CASE("six triangles of an octahedron are a ring of bodies, with axes that meet") {
  RandomNumbers random(42);
  const Eigen::Matrix3Xd points = random.points(3, 6, 1);
  const ProblemStatement problem =
      bodies_of(points, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}, {4, 5, 0}, {5, 0, 1}}, random);
  CHECK(check_counts(problem, points, 16).proofs->are_complete());
}

TEST_CASE("a ring with three axes through a point has 8 postures") {
  RandomNumbers random(43);
  const Eigen::Matrix3Xd points = random.points(3, 10, 1);
  const ProblemStatement problem = bodies_of(
      points, {{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}, {6, 7, 8}, {6, 8, 9}, {6, 9, 0, 1}}, random);
  check_counts(problem, points, 8);
}

TEST_CASE("a ring with three parallel axes has 8 postures, whichever bodies they are in") {
  RandomNumbers random(44);
  for (const int first : {0, 4, 8}) {
    Eigen::Matrix3Xd points = random.points(3, 12, 1);
    const Eigen::Vector3d along = points.col(first + 1) - points.col(first);
    for (const int hinge : {2, 4}) {
      const int from = (first + hinge) % 12;
      points.col(from + 1) = points.col(from) + along;
    }
    check_counts(ring_of(points, random), points, 8);
  }
}

TEST_CASE("what Newton's method finds of a ring are its real postures") {
  RandomNumbers random(45);
  const Eigen::Matrix3Xd points = random.points(3, 12, 1);
  const Scene scene = Scene::unchecked(ring_of(points, random));
  const Answer loops = solve(scene, Monodromy{.certify = true});
  const Answer newton = solve(scene, NewtonMultistart{.seed = 3, .certify = true});
  CHECK(newton.status == RunStatus::complete);
  CHECK(newton.failed_checks.empty());
  CHECK(newton.solutions.size() == loops.proofs->real);
  CHECK(classes_of(scene, {&loops, &newton}, in_unit(scene, points)) == 16);
}

TEST_CASE("bodies of a tree turn about their hinges, each to two places at a distance") {
  RandomNumbers random(46);
  const Eigen::Matrix3Xd points = random.points(3, 12, 1);
  ProblemStatement problem =
      bodies_of(points, {{0, 1, 2}, {0, 1, 3, 4, 5, 6}, {3, 4, 7}, {5, 6, 8, 9, 10}, {9, 10, 11}}, random);
  for (const int point : {3, 7, 8, 11}) add_distance(2, point, points, problem);
  check_counts(problem, points, 16);
}

TEST_CASE("a hinged body carries lines and planes") {
  RandomNumbers random(47);
  const Eigen::Matrix3Xd points = random.points(3, 4, 1);
  ProblemStatement problem = bodies_of(points, {{0, 1, 2}, {0, 1, 3}}, random);
  Figure figure;
  figure.points = points;
  // The second body as it is given, where the figure has it.
  const auto given = [&](int i) {
    const BodyElement& element = problem.bodies[1].elements[static_cast<std::size_t>(i)];
    return Eigen::Vector3d(element.numbers[0].value, element.numbers[1].value, element.numbers[2].value);
  };
  const auto frame = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    Eigen::Matrix3d result;
    result << a, b, a.cross(b);
    return result;
  };
  const Eigen::Matrix3d turn = frame(points.col(1) - points.col(0), points.col(3) - points.col(0)) *
                               frame(given(1) - given(0), given(2) - given(0)).inverse();
  const auto moved = [&](const Eigen::Vector3d& at) {
    return Eigen::Vector3d(points.col(0) + turn * (at - given(0)));
  };
  const Eigen::Vector3d on_line = random.point(3, 1), along = random.point(3, 1), normal = random.point(3, 1);
  const double offset = random.uniform(0.1, 1);
  const auto decimals = [](const Eigen::Vector3d& v) {
    return std::vector<Decimal>{{v.x(), ""}, {v.y(), ""}, {v.z(), ""}};
  };
  SECTION("with a point at a distance from a plane: 2 postures") {
    problem.planes = {"h"};
    std::vector<Decimal> numbers = decimals(normal);
    numbers.push_back({offset, ""});
    problem.bodies[1].elements.push_back({4, numbers});
    const Eigen::Vector3d turned = (turn * normal).normalized();
    figure.planes = {{turned, turned.dot(moved(normal.normalized() * (offset / normal.norm())))}};
    problem.relations.push_back({"c",
                                 "distance",
                                 {{2}, {4}},
                                 Relation::Form::length,
                                 {turned.dot(points.col(2)) - figure.planes[0].offset, ""}});
    check_counts(problem, figure, 2);
  }
  SECTION("with a point at a distance from a line: 4 postures") {
    problem.lines = {"L"};
    std::vector<Decimal> numbers = decimals(on_line);
    for (const Decimal& number : decimals(along)) numbers.push_back(number);
    problem.bodies[1].elements.push_back({4, numbers});
    figure.lines = {{moved(on_line), (turn * along).normalized()}};
    const double apart = (points.col(2) - figure.lines[0].point).cross(figure.lines[0].direction).norm();
    problem.constraints.push_back({"d", {2, 4}, {apart, ""}, false});
    check_counts(problem, figure, 4);
  }
}

TEST_CASE("a hinge's points may be as far apart in its bodies but for rounding") {
  RandomNumbers random(48);
  Eigen::Matrix3Xd points = random.points(3, 12, 1);
  ProblemStatement problem = ring_of(points, random);
  for (RigidBody& body : problem.bodies)
    for (BodyElement& element : body.elements)
      for (Decimal& number : element.numbers) number.value = std::round(number.value * 1e10) / 1e10;
  const Answer answer = solve(Scene::unchecked(problem), Monodromy{.certify = true});
  check_complete(answer, 16);
  CHECK(answer.proofs->are_complete());
}

TEST_CASE("the unit of a ring changes no bit") {
  RandomNumbers random(49);
  const Eigen::Matrix3Xd points = random.points(3, 12, 1);
  const ProblemStatement problem = ring_of(points, random);
  const Answer answer = solve(Scene::unchecked(problem), Monodromy{.certify = true});
  for (const int exponent : {-300, 300}) {
    ProblemStatement scaled = problem;
    for (RigidBody& body : scaled.bodies)
      for (BodyElement& element : body.elements)
        for (Decimal& number : element.numbers) number.value = std::ldexp(number.value, exponent);
    const Answer other = solve(Scene::unchecked(scaled), Monodromy{.certify = true});
    REQUIRE(other.solutions.size() == answer.solutions.size());
    for (std::size_t i = 0; i < answer.solutions.size(); ++i) {
      CHECK(other.solutions[i].figure.points == answer.solutions[i].figure.points);
      CHECK(other.solutions[i].error_bound == answer.solutions[i].error_bound);
    }
  }
}

TEST_CASE("rings of five and seven bodies are refused with what is wrong") {
  RandomNumbers random(50);
  const auto defect = [&](int bodies) {
    const Structure structure =
        analyse_general_structure(Scene::unchecked(ring_of(random.points(3, 2 * bodies, 1), random)));
    REQUIRE(structure.defects.size() == 1);
    return structure.defects.front();
  };
  const StructureDefect five = defect(5), seven = defect(7);
  CHECK(five.kind == StructureDefect::Kind::over_constrained);
  CHECK(five.what.find("the joints of body 'b4'") != std::string::npos);
  CHECK(seven.kind == StructureDefect::Kind::under_constrained);
}

TEST_CASE("bodies that close a loop with too many hinges are named") {
  RandomNumbers random(51);
  // Four bodies, each hinged to each of the others.
  const ProblemStatement problem =
      bodies_of(random.points(3, 12, 1),
                {{0, 1, 2, 3, 4, 5}, {0, 1, 6, 7, 8, 9}, {2, 3, 6, 7, 10, 11}, {4, 5, 8, 9, 10, 11}}, random);
  const auto reason = why_no_system(Scene::unchecked(problem));
  REQUIRE(reason);
  CHECK(reason->find("body 'b3' closes a loop with more than two hinges") == 0);
}

TEST_CASE(
    "a planar four-bar has 6 postures with a coupler point on a circle, and 4 with an angle of its cranks") {
  // The coupler curve is a tricircular sextic; with the angle, crank and rocker turn as one, on either side.
  RandomNumbers random(52);
  const Eigen::Matrix3Xd points = random.points(2, 6, 1);
  ProblemStatement problem = bodies_of(points, {{0, 3, 5}, {0, 1}, {1, 2, 4}, {2, 3}}, random);
  problem.dimension = 2;
  for (RigidBody& body : problem.bodies)
    for (BodyElement& element : body.elements) {
      const Eigen::Vector3d at = points.col(element.entity);
      element.numbers = {{at.x(), ""}, {at.y(), ""}};
    }
  SECTION("on a circle") {
    add_distance(4, 5, points, problem);
    check_counts(problem, points, 6);
  }
  SECTION("with an angle") {
    const Eigen::Vector3d crank = points.col(1) - points.col(0), rocker = points.col(2) - points.col(3);
    problem.relations.push_back({"a",
                                 "angle",
                                 {{0, 1}, {3, 2}},
                                 Relation::Form::cosine,
                                 {crank.normalized().dot(rocker.normalized()), ""}});
    check_counts(problem, points, 4);
  }
}
