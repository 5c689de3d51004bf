#include "solvers/elements/stated_signs.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "solvers/elements/general_structure.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

Relation orientation(const std::string& id, std::initializer_list<int> of, int sign) {
  Relation relation{id, "orientation", {}, Relation::Form::none};
  for (const int point : of) relation.of.push_back({point});
  relation.sign = sign;
  return relation;
}

Relation angle(Operand a, Operand b, double degrees) {
  return {"angle", "angle", {a, b}, Relation::Form::degrees, {degrees, ""}};
}

ProblemStatement space(int points) {
  ProblemStatement problem;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  problem.reference = Reference{0, 1, 2};
  return problem;
}

Standing standing(const ProblemStatement& problem, const Figure& figure, double error) {
  return verdict_on(stated_signs(problem), figure, error).standing;
}

}  // namespace

TEST_CASE("an orientation is the sign of the determinant, by hand") {
  ProblemStatement problem = space(4);
  Figure figure{Eigen::Matrix3Xd::Zero(3, 4), {}};
  figure.points.rightCols(3) = Eigen::Matrix3d::Identity();
  problem.relations = {orientation("o", {0, 1, 2, 3}, 1)};
  CHECK(standing(problem, figure, 0) == Standing::as_stated);
  problem.relations = {orientation("o", {0, 2, 1, 3}, 1)};
  CHECK(standing(problem, figure, 0) == Standing::not_as_stated);
  problem.relations = {orientation("o", {3, 1, 2, 0}, -1)};
  CHECK(standing(problem, figure, 0) == Standing::as_stated);

  problem.dimension = 2;
  problem.relations = {orientation("o", {0, 1, 2}, 1)};
  CHECK(standing(problem, figure, 0) == Standing::as_stated);
  problem.relations = {orientation("o", {2, 1, 0}, 1)};
  CHECK(standing(problem, figure, 0) == Standing::not_as_stated);
}

TEST_CASE("a motion keeps how a figure stands, and a mirror turns it over") {
  RandomNumbers random(61);
  for (int i = 0; i < 20; ++i) {
    ProblemStatement problem = space(4);
    problem.relations = {orientation("o", {0, 1, 2, 3}, 1)};
    Figure figure{random.points(3, 4, 1), {}};
    const Standing before = standing(problem, figure, 1e-12);
    REQUIRE(before != Standing::undecided);
    const Eigen::Quaterniond turn = samples::random_turn(3, random);
    const Eigen::Vector3d shift = random.point(3, 5);
    for (auto point : figure.points.colwise()) point = turn * Eigen::Vector3d(point) + shift;
    CHECK(standing(problem, figure, 1e-12) == before);
    figure.points.row(1) *= -1;
    CHECK(standing(problem, figure, 1e-12) ==
          (before == Standing::as_stated ? Standing::not_as_stated : Standing::as_stated));
  }
}

TEST_CASE("a sign is undecided where the error reaches the other side, and not where it does not") {
  ProblemStatement problem = space(3);
  problem.dimension = 2;
  problem.relations = {orientation("o", {0, 1, 2}, 1)};
  Figure figure{Eigen::Matrix3Xd::Zero(3, 3), {}};
  figure.points(0, 1) = 1;
  figure.points(0, 2) = 0.5;
  for (const double height : {1e-3, -1e-3}) {
    figure.points(1, 2) = height;
    // Ends of the base and the third point each move by the error, so that twice the error flattens it.
    CHECK(standing(problem, figure, 0.3e-3) == (height > 0 ? Standing::as_stated : Standing::not_as_stated));
    CHECK(standing(problem, figure, 0.7e-3) == Standing::undecided);
  }
  figure.points(1, 2) = 0;
  CHECK(standing(problem, figure, 0) == Standing::undecided);
}

TEST_CASE("what is not as stated outweighs what is undecided, and both are named") {
  ProblemStatement problem = space(5);
  problem.dimension = 2;
  Figure figure{Eigen::Matrix3Xd::Zero(3, 5), {}};
  figure.points.row(0) << 0, 1, 2, 0, 1;
  figure.points.row(1) << 0, 0, 0, 1, 1;
  const Relation flat = orientation("flat", {0, 1, 2}, 1), right = orientation("right", {0, 1, 3}, 1),
                 wrong = orientation("wrong", {0, 1, 4}, -1);
  problem.relations = {right};
  CHECK(verdict_on(stated_signs(problem), figure, 1e-9) == SignVerdict{});
  problem.relations = {right, flat};
  CHECK(verdict_on(stated_signs(problem), figure, 1e-9) == SignVerdict{Standing::undecided, {1}});
  for (const auto& [relations, number] :
       {std::pair(std::vector{flat, right, wrong}, 2), std::pair(std::vector{wrong, flat}, 0)}) {
    problem.relations = relations;
    CHECK(verdict_on(stated_signs(problem), figure, 1e-9) == SignVerdict{Standing::not_as_stated, {number}});
  }
}

TEST_CASE("an angle of segments has a sign where a length is free, from start to end of each") {
  ProblemStatement problem = space(3);
  Figure figure{Eigen::Matrix3Xd::Zero(3, 3), {}};
  figure.points.col(1) << 1, 0, 0;
  figure.points.col(2) << 1, 1, 0;
  const auto with = [&](const Relation& relation) {
    problem.relations = {relation};
    return stated_signs(problem);
  };
  const Operand forth{0, 1}, back{1, 0}, across{0, 2};
  CHECK(verdict_on(with(angle(forth, across, 45)), figure, 1e-9).standing == Standing::as_stated);
  CHECK(verdict_on(with(angle(forth, across, 135)), figure, 1e-9).standing == Standing::not_as_stated);
  CHECK(verdict_on(with(angle(back, across, 135)), figure, 1e-9).standing == Standing::as_stated);
  problem.constraints = {{"d", {1, 0}, {1, ""}, false}};
  CHECK(with(angle(forth, across, 45)).size() == 1);
  problem.constraints.push_back({"e", {0, 2}, {2, ""}, true});
  CHECK(with(angle(forth, across, 45)).size() == 1);
  problem.constraints.back().is_squared = false;
  CHECK(with(angle(forth, across, 45)).empty());
}

TEST_CASE("segments are turned over from those of given lengths on, where angles ask for it") {
  ProblemStatement problem = space(4);
  ComplexPoints points = ComplexPoints::Zero(3, 4);
  points.col(1) << 1, 0, 0;
  points.col(2) << 1, 1, 0;
  points.col(3) << -1, 0.5, 0;
  using Turned = std::vector<std::array<int, 2>>;
  const Operand first{0, 1}, second{0, 2}, third{3, 0};
  // As they lie, the first two are at 45 degrees, the last two at 72 and the outer ones at 27.
  problem.relations = {angle(first, second, 135), angle(second, third, 108)};
  CHECK(turned_segments(problem, points) == Turned{{0, 2}});
  problem.constraints = {{"d", {0, 2}, {1.5, ""}, false}};
  CHECK(turned_segments(problem, points) == Turned{{0, 1}, {0, 3}});
  problem.relations = {angle(first, second, 45), angle(first, third, 135)};
  CHECK(turned_segments(problem, points) == Turned{{0, 3}});
}

TEST_CASE("an orientation that other constraints make flat is refused") {
  RandomNumbers random(62);
  const auto refused = [](const ProblemStatement& problem, const std::string& where) {
    CHECK_THROWS_WITH(require_general_well_posed(problem, "file"),
                      Catch::Contains("'side'") && Catch::Contains(where) && Catch::Contains("no sign"));
  };
  ProblemStatement plane;
  plane.dimension = 2;
  plane.points = {"a", "b", "c", "d"};
  plane.reference = Reference{0, 1};
  plane.constraints = {{"ab", {0, 1}, {1, ""}, false},
                       {"ac", {0, 2}, {2, ""}, false},
                       {"ad", {0, 3}, {1.5, ""}, false},
                       {"bd", {1, 3}, {1.25, ""}, false}};
  plane.relations = {{"row", "collinear", {{0}, {1}, {2}}, Relation::Form::none}};
  CHECK_NOTHROW(require_general_well_posed(plane, "file"));
  plane.relations.push_back(orientation("side", {0, 1, 3}, 1));
  CHECK_NOTHROW(require_general_well_posed(plane, "file"));
  plane.relations.back() = orientation("side", {2, 0, 1}, 1);
  refused(plane, "c, a and b");
  refused(plane, "on a line");

  ProblemStatement platform = samples::random_platform(3, random);
  platform.relations = {orientation("side", {0, 1, 6, 7}, 1)};
  CHECK_NOTHROW(require_general_well_posed(platform, "file"));
  for (const int i : {0, 1, 2, 3})
    platform.bodies[0].elements[static_cast<std::size_t>(i)].numbers[2] = {0, ""};
  platform.relations = {orientation("side", {0, 1, 2, 3}, 1)};
  refused(platform, "in a plane");
}
