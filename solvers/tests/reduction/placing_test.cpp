/// Elements placed one by one, whatever their kinds are: counts from theory, and the same solutions as of the scene in
/// one piece.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/reduction/compared_answers.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

/// A scene while it grows: elements at random, and constraints with the values that these have.
struct Growing {
  RandomNumbers random;
  ProblemStatement problem{};
  std::vector<Eigen::Vector3d> points{};
  std::vector<LinePosition> lines{};
  std::vector<PlanePosition> planes{};

  explicit Growing(std::uint64_t seed) : random(seed) {}

  void add_points(int count, bool is_fixed) {
    for (int i = 0; i < count; ++i) {
      points.push_back(random.point(3, 2));
      problem.points.push_back("p" + std::to_string(problem.points.size()));
      if (is_fixed) problem.fixed_points.emplace_back(points.back());
      if (!is_fixed && !problem.fixed_points.empty()) problem.fixed_points.emplace_back();
    }
  }
  void add_line() {
    const Eigen::Vector3d at = random.point(3, 1);
    lines.push_back({at, random.point(3, 1).normalized()});
    problem.lines.push_back("L" + std::to_string(problem.lines.size()));
    problem.fixed_lines.emplace_back();
  }
  void add_plane() {
    const Eigen::Vector3d normal = random.point(3, 1).normalized();
    planes.push_back({normal, random.uniform(0.2, 1)});
    problem.planes.push_back("h" + std::to_string(problem.planes.size()));
  }
  std::string next_id() const {
    return "c" + std::to_string(problem.constraints.size() + problem.relations.size());
  }
  int line(int i) const { return problem.line_entity(i); }
  int plane(int i) const { return problem.plane_entity(i); }

  void points_apart(int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    problem.constraints.push_back({next_id(), {a, b}, {(points[i] - points[j]).norm(), ""}, false});
  }
  void from_line(int point, int of) {
    const LinePosition& line_at = lines[static_cast<std::size_t>(of)];
    const Eigen::Vector3d offset = points[static_cast<std::size_t>(point)] - line_at.point;
    problem.constraints.push_back(
        {next_id(), {point, line(of)}, {offset.cross(line_at.direction).norm(), ""}, false});
  }
  void from_plane(int point, int of) {
    const PlanePosition& at = planes[static_cast<std::size_t>(of)];
    const double distance = at.normal.dot(points[static_cast<std::size_t>(point)]) - at.offset;
    problem.relations.push_back(
        {next_id(), "distance", {{point}, {plane(of)}}, Relation::Form::length, {distance, ""}});
  }
  void line_to_plane(int of, int to) {
    const double sine =
        lines[static_cast<std::size_t>(of)].direction.dot(planes[static_cast<std::size_t>(to)].normal);
    problem.relations.push_back({next_id(),
                                 "angle",
                                 {{line(of)}, {plane(to)}},
                                 Relation::Form::cosine,
                                 {std::sqrt(1 - sine * sine), ""}});
  }
  void octahedron() {
    add_points(6, false);
    for (int a = 0; a < 6; ++a)
      for (int b = a + 1; b < 6; ++b)
        if (b != a + 3) points_apart(a, b);
  }
};

}  // namespace

TEST_CASE(
    "an octahedron and a line at distances from four of its points: 16 times 12, half up to reflection") {
  for (const std::uint64_t seed : {1U, 2U}) {
    Growing scene(seed);
    scene.octahedron();
    scene.add_line();
    const int left_out = scene.random.index(6);
    const int also = (left_out + 1 + scene.random.index(5)) % 6;
    for (int point = 0; point < 6; ++point)
      if (point != left_out && point != also) scene.from_line(point, 0);
    CHECK(placed_names(scene.problem) == std::vector<std::string>{"L0"});
    const Answer answer = answer_to(scene.problem);
    check_count(answer, 96);
    CHECK(answer.proofs->are_complete());
    CHECK(answer.counts.generic == Natural(96));
    CHECK(answer.counts.complex_up_to_reflection == Natural(96));
    const Answer eliminated = answer_to(scene.problem, "on", "cayley-menger");
    check_count(eliminated, 96);
    CHECK(classes_of(Scene::unchecked(scene.problem), answer, eliminated) == 96);
    const Answer real = answer_to(scene.problem, "on", "box-subdivision");
    CHECK(real.claim == Claim::all_real);
    CHECK(real.status == RunStatus::complete);
    CHECK(real.solutions.size() == real_ones(answer));
  }
}

TEST_CASE("two lines at distances from four given points each: 12 times 12, in one piece too") {
  Growing scene(9);
  scene.add_points(4, true);
  for (int line = 0; line < 2; ++line) {
    scene.add_line();
    for (int point = 0; point < 4; ++point) scene.from_line(point, line);
  }
  for (const std::string reduce : {"on", "off"}) check_count(answer_to(scene.problem, reduce), 144);
}

TEST_CASE("a plane at signed distances from three points: 2, as a vector n with n·n = 1 on a line") {
  Growing scene(3);
  scene.add_points(3, true);
  scene.add_plane();
  for (int point = 0; point < 3; ++point) scene.from_plane(point, 0);
  check_count(answer_to(scene.problem), 2);
}

TEST_CASE("a point by two planes and a distance: 2, on a sphere and a line") {
  Growing scene(4);
  scene.add_points(4, true);
  scene.add_points(1, false);
  scene.add_plane();
  scene.add_plane();
  for (int point = 0; point < 3; ++point) {
    scene.from_plane(point, 0);
    scene.from_plane(point + 1, 1);
  }
  scene.from_plane(4, 0);
  scene.from_plane(4, 1);
  scene.points_apart(0, 4);
  check_same_in_one_piece(scene.problem, 2 * 2 * 2);
}

TEST_CASE(
    "a line after a plane after a line: 12 tangents of four spheres, 4 planes, 4 tangents of two circles") {
  Growing scene(5);
  scene.add_points(5, true);
  scene.add_line();
  scene.add_plane();
  scene.add_line();
  const PlanePosition plane = scene.planes[0];
  const Eigen::Vector3d across = scene.random.point(3, 1).cross(plane.normal).normalized();
  const Eigen::Vector3d beside = scene.random.point(3, 1);
  scene.lines[1] = {beside - (plane.normal.dot(beside) - plane.offset) * plane.normal, across};
  for (int point = 0; point < 4; ++point) scene.from_line(point, 0);
  scene.from_plane(1, 0);
  scene.from_plane(4, 0);
  scene.line_to_plane(0, 0);
  scene.problem.relations.push_back(
      {"in", "on", {{scene.line(1)}, {scene.plane(0)}}, Relation::Form::none, {}, 0});
  scene.from_line(0, 1);
  scene.from_line(2, 1);
  CHECK(placed_names(scene.problem) == std::vector<std::string>{"L0", "h0", "L1"});
  check_count(answer_to(scene.problem), 12 * 4 * 4);
}

TEST_CASE("what hangs on a plane that hangs on an octahedron is placed in any order and any unit") {
  Growing scene(6);
  scene.octahedron();
  scene.add_points(1, false);
  scene.add_plane();
  for (const int point : {1, 3, 4}) scene.from_plane(point, 0);
  scene.from_plane(6, 0);
  scene.points_apart(0, 6);
  scene.points_apart(5, 6);
  // 8 octahedra, the plane on either side of three points, the point on two spheres and a plane.
  const Answer answer = answer_to(scene.problem);
  check_count(answer, 8 * 2 * 2);
  CHECK(placed_names(scene.problem) == std::vector<std::string>{"h0", "p6"});
  ProblemStatement scaled = scene.problem;
  for (DistanceConstraint& constraint : scaled.constraints) constraint.given.value *= 1.7e5;
  for (Relation& relation : scaled.relations) relation.given.value *= 1.7e5;
  std::ranges::reverse(scaled.constraints);
  std::ranges::reverse(scaled.relations);
  const Answer other = answer_to(scaled);
  check_count(other, 8 * 2 * 2);
  CHECK(real_ones(other) == real_ones(answer));
}

TEST_CASE("what is not known of the core is not known of the whole") {
  RandomNumbers random(7);
  ProblemStatement problem = samples::random_octahedral(1, random);
  problem.planes = {"h5"};
  problem.lines = {"L"};
  for (Relation& relation : problem.relations)
    for (Operand& operand : relation.of)
      if (operand.entity == 5) operand.entity = problem.plane_entity(0);
  for (int point = 0; point < 4; ++point)
    problem.constraints.push_back({"L" + std::to_string(point),
                                   {point, problem.line_entity(0)},
                                   {random.uniform(0.5, 1.5), ""},
                                   false});
  CHECK(placed_names(problem) == std::vector<std::string>{"L"});
  const Answer all = answer_to(problem);
  CHECK(all.status == RunStatus::complete);
  CHECK(all.failed_checks.empty());
  CHECK(all.solutions.size() == 8 * 12);
  CHECK(all.proofs->classes == 8 * 12);
  const Answer some = answer_to(problem, "on", "newton-multistart");
  CHECK(some.claim == Claim::some_real);
  CHECK_FALSE(some.counts.complex_up_to_reflection);
}

TEST_CASE("solutions that are too many to be listed are counted, those of independent steps without a list") {
  Growing scene(8);
  scene.add_points(4, true);
  scene.add_points(1, true);
  for (int i = 0; i < 3; ++i) {
    scene.add_plane();
    for (int point = i; point < i + 3; ++point) scene.from_plane(point, i);
  }
  for (int i = 0; i < 5; ++i) {
    scene.add_plane();
    for (int point = 0; point < 3; ++point) scene.from_plane(point, 3 + i);
  }
  const Answer answer = solve(Scene::unchecked(scene.problem), "monodromy", {}, {.max_solutions = 20});
  INFO(answer.reason);
  CHECK(answer.solutions.size() == 20);
  CHECK(answer.counts.complex_up_to_reflection == Natural::power_of_two(8));
  CHECK(answer.status == RunStatus::partial);
}

TEST_CASE("scenes that sign or side tell apart, and bare simplices, are left in one piece") {
  Growing triangle(9);
  triangle.add_points(3, false);
  triangle.points_apart(0, 1);
  triangle.points_apart(0, 2);
  triangle.points_apart(1, 2);
  triangle.add_plane();
  for (int point = 0; point < 3; ++point) triangle.from_plane(point, 0);
  CHECK(placed_names(triangle.problem).empty());
  CHECK(placed_names(samples::point_at_an_angle(40)).empty());
}
