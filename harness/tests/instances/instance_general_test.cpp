/// gcsbench-instance/2: planes, bodies and what they have in common with other scenes. Expected values are those of the
/// files and of elementary geometry.

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "harness/tests/instances/general_samples.hpp"
#include "harness/tests/instances/instance_samples.hpp"

namespace {

using namespace gcs::samples;
using gcs::Operand;
using gcs::ProblemStatement;
using gcs::Relation;
using nlohmann::json;

}  // namespace

TEST_CASE("planes are read with their positions") {
  json document = with(scene(), "/fixed", {{"E", {{"normal", {0, 0, 2}}, {"offset", 3}}}, {"p1", {0, 0, 1}}});
  const ProblemStatement problem = parsed(document).problem;
  CHECK(problem.is_general());
  CHECK(problem.planes == std::vector<std::string>{"E", "F"});
  CHECK(problem.entity_count() == 8);
  CHECK(problem.name(7) == "F");
  CHECK(problem.fixed_planes.at(0)->normal == Eigen::Vector3d(0, 0, 1));
  CHECK(problem.fixed_planes.at(0)->offset == 1.5);
  CHECK_FALSE(problem.fixed_planes.at(1).has_value());
  CHECK(problem.is_fixed(6));
  CHECK_FALSE(problem.is_fixed(7));
  CHECK(problem.has_fixed());
  CHECK_FALSE(problem.is_anchored());  // a plane and a point leave the turns about the line across it
  REQUIRE(problem.reference);
  CHECK(problem.reference->origin == 0);
  CHECK(problem.reference->axis == 6);
  document["fixed"]["E"]["normal"] = {0, 0, 0};
  check_refused(document, "/fixed/E/normal", "the normal is zero");
  check_refused(with(document, "/fixed/E", {0, 0, 1}), "/fixed/E", "an object is needed");
  check_refused(with(document, "/fixed/E", {{"normal", {0, 0, 1}}}), "/fixed/E", "'offset' is missing");
}

TEST_CASE("a sketch places planes, and may leave out what is fixed") {
  json document = with(scene(), "/fixed", {{"p1", {0, 0, 1}}});
  document["sketch"] = json::parse(R"({
    "p2": [1, 0, 0], "p3": [0, 1, 0], "p4": [0, 0, 5],
    "L": {"point": [0, 0, 0], "direction": [0, 5, 0]}, "M": {"point": [0, 0, 1], "direction": [1, 0, 0]},
    "E": {"normal": [0, 3, 4], "offset": 10}, "F": {"normal": [1, 0, 0], "offset": -1}})");
  const gcs::Figure sketch = *parsed(document).problem.sketch;
  CHECK(sketch.points.col(0) == Eigen::Vector3d(0, 0, 1));
  CHECK(sketch.lines[0].direction == Eigen::Vector3d(0, 1, 0));
  REQUIRE(sketch.planes.size() == 2);
  CHECK((sketch.planes[0].normal - Eigen::Vector3d(0, 0.6, 0.8)).norm() < 1e-15);
  CHECK(sketch.planes[0].offset == Approx(2));
  CHECK(sketch.planes[1].offset == -1);
  check_refused(with(document, "/sketch/F", nullptr), "/sketch", "no position for 'F'");
  document["fixed"]["F"] = {{"normal", {1, 0, 0}}, {"offset", -2}};
  check_refused(document, "/sketch/F", "'F' is fixed somewhere else");
}

TEST_CASE("what space alone has is refused in the plane") {
  const auto in_the_plane = [](const json& document) { return with(document, "/dimension", 2); };
  check_refused(in_the_plane(scene()), "/planes", "planes are for space only");
  json body = with(bodies(), "/bodies/base", {{"E", {{"normal", {1, 0}}, {"offset", 1}}}});
  check_refused(in_the_plane(body), "/bodies/base/E", "planes are for space only");
  check_constraint_refused(plane_scene(), between("meet", R"("L")", R"("M")"), "/type",
                           "'meet' is for space only");
  check_constraint_refused(plane_scene(), R"({"type": "coplanar", "between": ["p1", "p2", "p3", "p4"]})",
                           "/type", "'coplanar' is for space only");
}

TEST_CASE("lines in the plane have two coordinates, and distances from them are relations") {
  json document = with(plane_scene(), "/fixed", {{"L", {{"point", {1, 0}}, {"direction", {0, 3}}}}});
  document = and_also(document, between("distance", R"("L")", R"("p1")", R"(, "squared": 2.5)"));
  const ProblemStatement problem = parsed(document).problem;
  CHECK(problem.fixed_lines[0]->point == Eigen::Vector3d(1, 0, 0));
  CHECK(problem.fixed_lines[0]->direction == Eigen::Vector3d(0, 1, 0));
  CHECK(problem.constraints.empty());
  REQUIRE(problem.relations.size() == 1);
  CHECK(problem.relations[0].type == "distance");
  CHECK(problem.relations[0].of == std::vector<Operand>{{4, -1}, {0, -1}});
  CHECK(problem.relations[0].form == Relation::Form::squared);
  CHECK(problem.relations[0].given.text == "2.5");
  check_refused(with(document, "/fixed/L/point", {1, 0, 0}), "/fixed/L/point", "exactly 2");
}

TEST_CASE("elements of bodies are elements of the scene, behind those that are listed") {
  json document = bodies();
  document["bodies"]["top"]["L"] = {{"point", {0, 0, 1}}, {"direction", {0, 2, 0}}};
  document["bodies"]["top"]["E"] = {{"normal", {0, 0, 2}}, {"offset", 3}};
  document["lines"] = {"M"};
  const ProblemStatement problem = parsed(document).problem;
  CHECK(problem.points == std::vector<std::string>{"q", "a1", "a2", "a3", "b1", "b2", "b3"});
  CHECK(problem.lines == std::vector<std::string>{"M", "L"});
  CHECK(problem.planes == std::vector<std::string>{"E"});
  REQUIRE(problem.bodies.size() == 2);
  CHECK(problem.bodies[0].name == "base");
  REQUIRE(problem.bodies[0].elements.size() == 3);
  CHECK(problem.bodies[0].elements[1].entity == 2);
  CHECK(problem.bodies[0].elements[1].numbers[0].text == "3");
  REQUIRE(problem.bodies[1].elements.size() == 5);
  std::map<int, std::vector<double>> numbers;
  for (const gcs::BodyElement& element : problem.bodies[1].elements)
    for (const gcs::Decimal& number : element.numbers) numbers[element.entity].push_back(number.value);
  CHECK(numbers[6] == std::vector<double>{1, 1.5, 0});
  CHECK(numbers[8] == std::vector<double>{0, 0, 1, 0, 2, 0});
  CHECK(numbers[9] == std::vector<double>{0, 0, 2, 3});
  CHECK(problem.constraints.at(0).between == std::array{1, 4});
  CHECK(problem.reference_body == 0);
  CHECK_FALSE(problem.reference.has_value());
}

TEST_CASE("a joint is one element of two bodies") {
  json document = with(bodies(), "/constraints", json::array());
  document["bodies"]["top"]["a1"] = {5, 5, 5};
  const ProblemStatement problem = parsed(document).problem;
  CHECK(problem.points == std::vector<std::string>{"q", "a1", "a2", "a3", "b1", "b2", "b3"});
  const std::vector<gcs::BodyElement>& top = problem.bodies[1].elements;
  CHECK(std::count_if(top.begin(), top.end(),
                      [](const gcs::BodyElement& element) { return element.entity == 1; }) == 1);
  SECTION("which two points make a hinge, at the same distance but for rounding") {
    document["bodies"]["top"]["a2"] = {5, 5, 8.000000001};
    CHECK(parsed(document).problem.bodies[1].elements.size() == 5);
    document["bodies"]["top"]["a2"] = {5, 5, 8.5};
    check_refused(document, "/bodies/top", "the distance of 'a1' and 'a2' is 3 in the body 'base' and 3.5");
  }
  SECTION("which three points do not make") {
    document["bodies"]["top"]["a2"] = {5, 5, 8};
    document["bodies"]["top"]["a3"] = {5, 9, 5};
    check_refused(document, "/bodies/top", "they are one body");
  }
  SECTION("which is of one kind") {
    document["bodies"]["top"]["a1"] = {{"point", {0, 0, 0}}, {"direction", {1, 0, 0}}};
    check_refused(document, "/bodies/top/a1", "'a1' is a line here and a point in another body");
  }
  SECTION("which a line makes, with a point of it") {
    for (const char* body : {"base", "top"})
      document["bodies"][body]["axis"] = {{"point", {5, 5, 5}}, {"direction", {1, 1, 1}}};
    document["bodies"]["base"]["axis"]["point"] = {-1, -1, -1};
    CHECK(parsed(document).problem.lines == std::vector<std::string>{"axis"});
    document["bodies"]["base"]["axis"]["point"] = {-1, -1, 2};
    check_refused(document, "/bodies/top", "they are one body");
    document["bodies"]["base"]["axis"]["point"] = {-1, -1, -1};
    document["bodies"]["top"]["axis"]["point"] = {5, 5, 8};  // √6 from the point
    check_refused(document, "/bodies/top",
                  "the distance of 'a1' and 'axis' is 0 in the body 'base' and 2.4494897");
  }
  SECTION("which planes make, parallel and as far apart") {
    document["bodies"]["top"].erase("a1");
    for (const char* body : {"base", "top"}) {
      document["bodies"][body]["E"] = {{"normal", {0, 0, 1}}, {"offset", 1}};
      document["bodies"][body]["F"] = {{"normal", {0, 0, 1}}, {"offset", 3}};
    }
    CHECK(parsed(document).problem.planes.size() == 2);
    document["bodies"]["top"]["F"]["normal"] = {0, 0, -2};
    check_refused(document, "/bodies/top",
                  "the cosine of the angle of 'E' and 'F' is 1 in the body 'base' and -1");
    document["bodies"]["top"]["F"] = {{"normal", {0, 0, 2}}, {"offset", 7}};
    check_refused(document, "/bodies/top", "the distance of 'E' and 'F' is 2 in the body 'base' and 2.5");
  }
}

TEST_CASE("bodies of the plane that share two points are one") {
  json document = json::parse(R"({
    "format": "gcsbench-instance/2", "id": "small", "dimension": 2, "points": [],
    "bodies": {"one": {"p": [0, 0], "q": [1, 0]}, "two": {"p": [0, 0], "r": [0, 1]}},
    "constraints": []})");
  CHECK(parsed(document).problem.bodies.size() == 2);
  document["bodies"]["two"]["q"] = {1, 0};
  check_refused(document, "/bodies/two", "one body");
}

TEST_CASE("a body has elements enough that its pose is determined") {
  const auto base = [](const json& elements) { return with(bodies(), "/bodies/base", elements); };
  const json line = {{"point", {0, 0, 0}}, {"direction", {1, 1, 0}}};
  const json plane = {{"normal", {1, 1, 0}}, {"offset", 2}};
  const json loose[] = {json::object(),
                        {{"a1", {0, 0, 0}}},
                        {{"a1", line}},
                        {{"a1", plane}},
                        {{"a1", {0, 0, 0}}, {"a2", {1, 1, 0}}},
                        {{"a1", {0, 0, 0}}, {"a2", {0.1, 0.2, 0.3}}, {"a3", {0.2, 0.4, 0.6}}},
                        {{"a1", {2, 2, 0}}, {"a2", line}},
                        {{"a1", {2, 0, 5}}, {"a2", plane}},
                        {{"a1", line}, {"a2", plane}},
                        {{"a1", plane}, {"a2", {{"normal", {1, 0, 0}}, {"offset", 2}}}}};
  const int motions[] = {6, 3, 2, 3, 1, 1, 1, 1, 1, 1};
  for (std::size_t i = 0; i < std::size(loose); ++i)
    check_refused(base(loose[i]), "/bodies/base",
                  "'base' do not determine its pose: they leave it " + std::to_string(motions[i]) +
                      " of 6 motions; give it");
  // The constraint of the sample names a1.
  const json enough[] = {{{"a1", {0, 0, 0}}, {"a2", {1, 0, 0}}, {"a3", {1, 1e-3, 0}}},
                         {{"a1", {1, 0, 0}}, {"a2", line}},
                         {{"a1", {1, 0, 0}}, {"a2", {1, 0, 1}}, {"a3", plane}}};
  for (const json& elements : enough) CHECK(parsed(base(elements)).problem.bodies.size() == 2);
  json flat = json::parse(R"({"format": "gcsbench-instance/2", "id": "small", "dimension": 2, "points": [],
    "bodies": {"one": {"p": [0, 0]}}, "constraints": []})");
  check_refused(flat, "/bodies/one", "1 of 3 motions; give it one more point");
  flat["bodies"]["one"]["L"] = {{"point", {5, 5}}, {"direction", {1, 0}}};
  CHECK(parsed(flat).problem.bodies.size() == 1);
}

TEST_CASE("names are unique over all kinds of elements") {
  check_refused(with(scene(), "/planes/1", "p1"), "/planes/1", "'p1' is given twice");
  check_refused(with(bodies(), "/points/0", "a1"), "/bodies/base/a1", "both free and in a body");
  check_refused(with(bodies(), "/points/0", "top"), "/bodies/top", "'top' is given twice");
  check_refused(with(bodies(), "/bodies/top/base", {0, 0, 0}), "/bodies/top/base", "'base' is given twice");
  check_refused(with(bodies(), "/bodies/top/", {0, 0, 0}), "/bodies/top/", "the name is empty");
  check_refused(with(bodies(), "/bodies/top/b1", {0, 0}), "/bodies/top/b1", "exactly 3");
  check_refused(with(bodies(), "/bodies/top/b1", {{"normal", {0, 0, 0}}, {"offset", 1}}),
                "/bodies/top/b1/normal", "zero");
  json crowd = bodies();
  for (int i = 0; i < 2000; ++i) crowd["bodies"]["top"]["c" + std::to_string(i)] = {i, 0, 0};
  check_refused(crowd, "/points", "up to 2000");
}

TEST_CASE("a scene has an element") {
  CHECK(parsed(with(scene(), "/points", json::array())).problem.points.empty());
  const json empty =
      with(with(with(scene(), "/points", json::array()), "/lines", nullptr), "/planes", nullptr);
  check_refused(empty, "/points", "name points, lines, planes or bodies");
}

TEST_CASE("the frame is that of a body, of the reference or of what is fixed") {
  const json by_body = with(bodies(), "/reference", {{"body", "top"}});
  CHECK(parsed(by_body).problem.reference_body == 1);
  check_refused(with(by_body, "/reference/body", "a1"), "/reference/body", "'a1' is a point; name a body");
  check_refused(with(by_body, "/reference/body", "topp"), "/reference/body", "did you mean 'top'?");
  check_refused(with(by_body, "/reference/origin", "a1"), "/reference/origin", "unknown field");
  const ProblemStatement by_points =
      parsed(with(bodies(), "/reference", {{"origin", "q"}, {"axis", "b1"}, {"plane", "a1"}})).problem;
  CHECK(by_points.reference_body == -1);
  CHECK(by_points.reference->axis == 4);
  const json fixed = with(bodies(), "/fixed", {{"b2", {0, 0, 0}}});
  CHECK(parsed(fixed).problem.reference_body == 1);
  check_refused(with(fixed, "/reference", {{"body", "top"}}), "/reference", "exclude each other");
  const json anchored = with(bodies(), "/fixed", {{"a1", {0, 0, 0}}, {"a2", {0, 3, 0}}, {"a3", {4, 0, 0}}});
  CHECK(parsed(anchored).problem.reference_body == -1);
  check_refused(with(bodies(), "/fixed", {{"q", {0, 0, 0}}}), "/fixed",
                "too few elements that are in no body");
}

TEST_CASE("fixed elements of a body are as it has them") {
  const json fixed = with(bodies(), "/fixed", {{"a1", {1, 1, 1}}, {"a2", {1, 1, 4}}});
  CHECK(parsed(fixed).problem.is_fixed(1));
  check_refused(with(fixed, "/fixed/a2", {1, 1, 5}), "/fixed",
                "the distance of 'a1' and 'a2' is 3 in the body 'base' and 4 in 'fixed'");
}

TEST_CASE("a sketch may leave out elements of a body whose pose it tells") {
  json document = bodies();
  // The first body turned by 90 degrees about the z-axis and moved by (1, 0, 0), with something for every body to bear.
  document["bodies"]["base"]["a4"] = {1, 2, 3};
  document["bodies"]["base"]["L"] = {{"point", {1, 2, 3}}, {"direction", {1, 0, 0}}};
  document["bodies"]["base"]["E"] = {{"normal", {1, 0, 0}}, {"offset", 7}};
  document["sketch"] = {{"q", {9, 9, 9}},  {"a1", {1, 0, 0}}, {"a2", {1, 3, 0}},  {"a3", {-3, 0, 0}},
                        {"b1", {0, 0, 5}}, {"b2", {1, 0, 5}}, {"b3", {0, 1.5, 5}}};
  const ProblemStatement problem = parsed(document).problem;
  const gcs::Figure& sketch = *problem.sketch;
  const auto a4 = std::find(problem.points.begin(), problem.points.end(), "a4") - problem.points.begin();
  CHECK((sketch.points.col(a4) - Eigen::Vector3d(-1, 1, 3)).norm() < 1e-14);
  CHECK((sketch.lines[0].point - Eigen::Vector3d(-1, 1, 3)).norm() < 1e-14);
  CHECK((sketch.lines[0].direction - Eigen::Vector3d(0, 1, 0)).norm() < 1e-14);
  CHECK((sketch.planes[0].normal - Eigen::Vector3d(0, 1, 0)).norm() < 1e-14);
  CHECK(sketch.planes[0].offset == Approx(7));
  check_refused(with(document, "/sketch/a3", nullptr), "/sketch", "no position for 'a3'");
  // Given positions stay as they are, whether or not the body can have them.
  document["sketch"]["a3"] = {-3.5, 0, 0};
  CHECK(parsed(document).problem.sketch->points.col(3) == Eigen::Vector3d(-3.5, 0, 0));
}

TEST_CASE("hints for distances do not fit other scenes") {
  const json with_angle =
      and_also(bodies(), between("angle", R"(["q", "a1"])", R"(["q", "b1"])", R"(, "degrees": 20)"));
  CHECK(parsed(with(with_angle, "/interpolation", {{"bent", "a1"}})).problem.interpolation.bent == 0);
  check_refused(with(with_angle, "/interpolation", {{"bent", "a2"}}), "/interpolation/bent",
                "only such lengths can be bent");
  check_refused(with(bodies(), "/construction", {{{"place", "q"}, {"from", json::array()}}}), "/construction",
                "distances between points alone");
}

TEST_CASE("a file of distances is the same problem in both formats") {
  for (const json& document : {plane(), space(), bipyramid(), tangents()}) {
    const ProblemStatement first = parsed(document).problem;
    const ProblemStatement second = parsed(with(document, "/format", "gcsbench-instance/2")).problem;
    CHECK_FALSE(second.is_general());
    CHECK(first.dimension == second.dimension);
    CHECK(first.points == second.points);
    CHECK(first.lines == second.lines);
    REQUIRE(first.constraints.size() == second.constraints.size());
    for (std::size_t i = 0; i < first.constraints.size(); ++i) {
      CHECK(first.constraints[i].id == second.constraints[i].id);
      CHECK(first.constraints[i].between == second.constraints[i].between);
      CHECK(first.constraints[i].given.text == second.constraints[i].given.text);
      CHECK(first.constraints[i].is_squared == second.constraints[i].is_squared);
    }
    CHECK(first.fixed_points == second.fixed_points);
    CHECK(first.fixed_texts == second.fixed_texts);
    CHECK(first.reference.has_value() == second.reference.has_value());
    REQUIRE(first.sketch.has_value() == second.sketch.has_value());
    if (first.sketch) CHECK(first.sketch->points == second.sketch->points);
    CHECK(first.interpolation.bent == second.interpolation.bent);
    CHECK(first.construction.size() == second.construction.size());
    CHECK(second.reference_body == -1);
  }
}

TEST_CASE("in both formats distances are checked in the same way") {
  const auto general = [](const json& document) { return with(document, "/format", "gcsbench-instance/2"); };
  check_refused(general(with(plane(), "/constraints/2", nullptr)), "/constraints", "under-constrained");
  check_refused(general(with(plane(), "/constraints", json::array())), "/constraints", "no constraint");
  check_refused(general(with(plane(), "/constraints/2/length", 8)), "/constraints/2", "a3 (p2–p3) is 8");
  check_refused(general(with(plane(), "/fixed", {{"p1", {0, 0}}})), "/reference", "exclude each other");
  check_refused(general(with(plane(), "/sketch/p3", {5, 0})), "/sketch", "on one line");
  check_refused(general(with(plane(), "/sketh", 1)), "/sketh", "did you mean 'sketch'?");
  check_refused(general(with(space(), "/constraints/6/length", 0)), "/constraints/6/length", "'on'");
}

TEST_CASE("what only the second format has is refused in the first with that remedy") {
  const std::string remedy = R"(give "format": "gcsbench-instance/2")";
  check_refused(with(space(), "/planes", {"E"}), "/planes", remedy);
  check_refused(with(space(), "/bodies", json::object()), "/bodies", remedy);
  check_refused(with(plane(), "/lines", {"L"}), "/lines", remedy);
  for (const std::string type :
       {"angle", "on", "meet", "parallel", "perpendicular", "collinear", "coplanar", "orientation"})
    check_refused(with(plane(), "/constraints/0/type", type), "/constraints/0/type", remedy);
  json two_lines = with(space(), "/lines", {"L", "M"});
  two_lines["constraints"][0]["between"] = {"L", "M"};
  check_refused(two_lines, "/constraints/0/between", remedy);
}

TEST_CASE("the shipped scenes of all elements say what their files say") {
  struct Expected {
    const char* id;
    std::size_t points, lines, planes, bodies, distances, relations;
  };
  // Counted in the files.
  for (const Expected& expected :
       {Expected{"dietmaier", 12, 0, 0, 2, 6, 0}, Expected{"platform", 12, 0, 0, 2, 6, 0},
        Expected{"planar-platform", 6, 0, 0, 2, 3, 0}, Expected{"octahedral-3p3h", 3, 0, 3, 0, 3, 9},
        Expected{"octahedral-4p2h", 4, 0, 2, 0, 5, 7}, Expected{"octahedral-5p1h", 5, 0, 1, 0, 8, 4},
        Expected{"octahedron-line", 6, 1, 0, 0, 16, 0},
        Expected{"three-points-three-lines-angles", 3, 3, 0, 0, 12, 3},
        Expected{"three-points-three-lines-distances", 3, 3, 0, 0, 12, 3},
        Expected{"two-lines", 4, 2, 0, 0, 8, 0}}) {
    INFO(expected.id);
    const ProblemStatement problem = gcs::load_instance(expected.id).problem;
    CHECK(problem.points.size() == expected.points);
    CHECK(problem.lines.size() == expected.lines);
    CHECK(problem.planes.size() == expected.planes);
    CHECK(problem.bodies.size() == expected.bodies);
    CHECK(problem.constraints.size() == expected.distances);
    CHECK(problem.relations.size() == expected.relations);
    CHECK(problem.sketch.has_value() == (std::string(expected.id) != "dietmaier"));
  }
  const ProblemStatement dietmaier = gcs::load_instance("dietmaier").problem;
  CHECK(dietmaier.points[7] == "b2");
  CHECK(dietmaier.bodies[1].elements[1].numbers[0].text == "0.542805");
  CHECK(dietmaier.constraints[5].between == std::array{5, 11});
  CHECK(dietmaier.constraints[5].given.text == "0.771071");
  CHECK(dietmaier.reference_body == 0);
  const ProblemStatement octahedral = gcs::load_instance("octahedral-3p3h").problem;
  CHECK(octahedral.constraints[2].id == "a5");
  CHECK(octahedral.relations[1].id == "a4");
  CHECK(octahedral.relations[1].of == std::vector<Operand>{{0, -1}, {5, -1}});
  CHECK(octahedral.relations[1].given.text == "-2.386319947234");
  CHECK(octahedral.relations[7].type == "angle");
  CHECK(octahedral.relations[7].form == Relation::Form::cosine);
  CHECK(octahedral.reference->plane == 2);
  // The normal there is no unit vector.
  const double length = Eigen::Vector3d(0.553128, -0.324503, -0.608507).norm();
  CHECK(octahedral.sketch->planes[2].offset == Approx(-0.236433557313 / length));
  const ProblemStatement two_lines = gcs::load_instance("two-lines").problem;
  CHECK(two_lines.sketch->points.col(0) == Eigen::Vector3d(-1.382585, 0.041213, -1.423988));
  CHECK(two_lines.fixed_texts[3][2] == "1.829177");
}
