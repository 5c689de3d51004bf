/// Problems with planes, bodies and constraints of all types, stated in C++: the calls say what a file would.

#include "solvers/solving/problem.hpp"

#include <catch2/catch.hpp>

using namespace gcs;

namespace {

std::string format_of(const Problem& problem) { return problem.instance().document.find("format")->text; }

std::vector<double> values(const BodyElement& element) {
  std::vector<double> result;
  for (const Decimal& number : element.numbers) result.push_back(number.value);
  return result;
}

}  // namespace

TEST_CASE("elements of all kinds are stated in C++") {
  Problem problem(3);
  problem.points("p").lines("L").planes("E");
  problem.body("b", {{"q", {1, "2.5", 3}}, {"M", {0, 0, 1}, {0, 1, 0}}, {"F", {0, 0, 2}, -3}});
  problem.fix("p", {0, 0, 0}).fix("E", {0, 3, 4}, 10).fix("L", {0, 0, 0}, {1, 0, 0});
  const ProblemStatement statement = problem.instance().problem;
  CHECK(statement.points == std::vector<std::string>{"p", "q"});
  CHECK(statement.lines == std::vector<std::string>{"L", "M"});
  CHECK(statement.planes == std::vector<std::string>{"E", "F"});
  REQUIRE(statement.bodies.size() == 1);
  CHECK(statement.bodies[0].name == "b");
  REQUIRE(statement.bodies[0].elements.size() == 3);
  CHECK(statement.bodies[0].elements[0].numbers[1].text == "2.5");
  CHECK(values(statement.bodies[0].elements[1]) == std::vector<double>{0, 0, 1, 0, 1, 0});
  CHECK(values(statement.bodies[0].elements[2]) == std::vector<double>{0, 0, 2, -3});
  CHECK(statement.fixed_planes[0]->offset == Approx(2));
  CHECK(statement.fixed_lines[0]->direction == Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("a sketch in C++ has planes") {
  Problem problem(3);
  problem.points("p").planes("E").on("p", "E").sketch("p", {0, 0, 0}).sketch("E", {0, 0, 2}, 4);
  CHECK(problem.instance().problem.sketch->planes.at(0).offset == 2);
}

TEST_CASE("constraints of all types are stated in C++") {
  Problem problem(3);
  problem.points("p", "q", "r", "s").lines("L", "M").planes("E");
  problem.angle("L", "M", "30.5")
      .angle_cosine({"p", "q"}, "E", 0.25)
      .on("p", "E")
      .meet("L", "M")
      .parallel({"p", "q"}, {"r", "s"})
      .perpendicular("L", "E")
      .collinear("p", "q", "r")
      .coplanar("p", "q", "r", "s")
      .orientation({"p", "q", "r", "s"}, -1)
      .distance("q", "E", -2);
  const std::vector<Relation> relations = problem.instance().problem.relations;
  const std::string types[] = {"angle",         "angle",     "on",       "meet",        "parallel",
                               "perpendicular", "collinear", "coplanar", "orientation", "distance"};
  REQUIRE(relations.size() == std::size(types));
  for (std::size_t i = 0; i < std::size(types); ++i) CHECK(relations[i].type == types[i]);
  CHECK(relations[0].form == Relation::Form::degrees);
  CHECK(relations[0].given.text == "30.5");
  CHECK(relations[1].form == Relation::Form::cosine);
  CHECK(relations[1].of == std::vector<Operand>{{0, 1}, {6, -1}});
  CHECK(relations[4].of == std::vector<Operand>{{0, 1}, {2, 3}});
  CHECK(relations[7].of.size() == 4);
  CHECK(relations[8].sign == -1);
  CHECK(relations[9].given.value == -2);
}

TEST_CASE("the format is the second where it has to be") {
  Problem triangle(2);
  triangle.points("a", "b", "c").distance("a", "b", 3).distance("b", "c", 4).distance("c", "a", 5);
  CHECK(format_of(triangle) == "gcsbench-instance/1");
  CHECK(format_of(triangle.orientation({"a", "b", "c"}, 1)) == "gcsbench-instance/2");
  Problem two_lines(3);
  two_lines.distance("L", "M", 1).lines("L", "M");
  CHECK(format_of(two_lines) == "gcsbench-instance/2");
  Problem in_the_plane(2);
  in_the_plane.points("p").lines("L").distance("p", "L", 1);
  CHECK(format_of(in_the_plane) == "gcsbench-instance/2");
  Problem bodies(2);
  bodies.body("one", {{"p", {0, 0}}, {"q", {1, 0}}});
  CHECK(format_of(bodies) == "gcsbench-instance/2");
}

TEST_CASE("what is wrong with a general problem is said with its place") {
  Problem problem(3);
  problem.planes("E").body("b", {{"q", {1, 2, 3}}});
  CHECK_THROWS_WITH(problem.instance(), Catch::StartsWith("problem: /bodies/b: ") && Catch::Contains("pose"));
}
