#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/instances/instance_samples.hpp"

namespace {

using namespace gcs::samples;
using gcs::InputError;
using gcs::Instance;
using nlohmann::json;

std::string message_of(const std::string& argument) {
  try {
    gcs::load_instance(argument);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() { std::filesystem::create_directories(path_); }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = path_ / name;
    std::ofstream(file) << text;
    return file.string();
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("gcsbench-instance-io-test-" + std::to_string(getpid()));
};

}  // namespace

TEST_CASE("every shipped instance loads") {
  const std::vector<std::string> ids = gcs::shipped_instances();
  CHECK(ids.size() >= 15);
  CHECK(std::is_sorted(ids.begin(), ids.end()));
  CHECK(std::count(ids.begin(), ids.end(), "schema") == 0);
  for (const std::string& id : ids) {
    INFO(id);
    const Instance instance = gcs::load_instance(id);
    CHECK(instance.id == id);
    CHECK_FALSE(instance.title.empty());
    CHECK(gcs::load_instance(std::string(GCSBENCH_SOURCE_DIR) + "/instances/" + id + ".json").id == id);
  }
}

TEST_CASE("all fields of an instance are read") {
  const Instance instance = parsed(plane());
  CHECK(instance.id == "small");
  CHECK(instance.title == "Triangle");
  CHECK(instance.notes == "right-angled");
  CHECK(instance.origin == "small.json");
  const gcs::ProblemStatement& problem = instance.problem;
  CHECK(problem.dimension == 2);
  CHECK(problem.points == std::vector<std::string>{"p1", "p2", "p3"});
  REQUIRE(problem.constraints.size() == 3);
  CHECK(problem.constraints[1].id == "a2");
  CHECK(problem.constraints[1].between == std::array{0, 2});
  CHECK(problem.constraints[1].is_squared);
  CHECK(problem.constraints[1].given.text == "16.0");
  CHECK(problem.constraints[1].given.value == 16);
  CHECK(problem.reference->origin == 0);
  CHECK(problem.reference->axis == 1);
  CHECK(problem.reference->plane == -1);
  CHECK(problem.sketch->points.col(2) == Eigen::Vector3d(0, 3, 0));
  CHECK(problem.interpolation.bent == 1);
  CHECK(problem.interpolation.bend == 1.5);
  REQUIRE(problem.construction.size() == 3);
  CHECK(problem.construction[2].place == 2);
  CHECK(problem.construction[2].from[1].from == 1);
  CHECK(problem.construction[2].from[1].constraint == 2);
  REQUIRE(instance.published.size() == 1);
  CHECK(instance.published[0].value == 2);
  CHECK(instance.published[0].by == "compass");
  CHECK(instance.document.find("notes")->text == "right-angled");
}

TEST_CASE("lines are read, and constraint ids have defaults by position") {
  const gcs::ProblemStatement problem = parsed(space()).problem;
  CHECK(problem.lines == std::vector<std::string>{"L"});
  CHECK(problem.constraints[9].id == "a10");
  CHECK(problem.constraints[9].between == std::array{4, 3});
  CHECK(problem.sketch->lines[0].point == Eigen::Vector3d(5, 0, 0.5));
  CHECK(problem.sketch->lines[0].direction == Eigen::Vector3d(0, 1, 0));
  CHECK(problem.interpolation.bent == -1);
  CHECK_FALSE(problem.reference.has_value());
}

TEST_CASE("fixed positions are read") {
  const gcs::ProblemStatement problem = parsed(tangents()).problem;
  CHECK(problem.fixed_points[3] == Eigen::Vector3d(-1, -1, 1));
  CHECK_FALSE(problem.fixed_lines[0].has_value());
}

TEST_CASE("fixed positions of any unit hold the plane still, and must not be far from the origin") {
  const auto beside = [](double unit, double offset) {
    const auto constraint = [&](const char* fixed) {
      return json{{"type", "distance"}, {"between", {"x", fixed}}, {"length", unit}};
    };
    return json{{"format", "gcsbench-instance/1"},
                {"id", "small"},
                {"dimension", 2},
                {"points", {"a", "b", "x"}},
                {"fixed", {{"a", {offset, offset}}, {"b", {offset + unit, offset}}}},
                {"constraints", {constraint("a"), constraint("b")}}};
  };
  for (const double unit : {1e-300, 1e-20, 1e-14, 1.0, 1e20, 1e150})
    CHECK(parsed(beside(unit, 0)).problem.is_fixed(0));
  CHECK(parsed(beside(1, 1e6)).problem.is_fixed(0));
  check_refused(beside(1, 1e9), "/fixed", "put the origin near");
  check_refused(beside(1024, 1e13), "/fixed", "put the origin near");
}

TEST_CASE("a point may have the distance zero to a line") {
  json document = with(space(), "/constraints/6/length", 0);
  CHECK(parsed(document).problem.constraints[6].given.value == 0);
  document["sketch"]["L"] = {{"point", {0, 5, 0}}, {"direction", {0, 1, 0}}};  // through p1
  CHECK(parsed(with(document, "/sketch/p3", {0.5, 1, 0})).problem.sketch.has_value());
}

TEST_CASE("a file that is no instance is refused") {
  check_refused(json::array(), "", "an object is needed");
  check_refused(with(plane(), "/format", nullptr), "", "'format' is missing");
  check_refused(with(plane(), "/format", "gcsbench-result/1"), "/format", "'gcsbench-instance/1'");
  check_refused(with(plane(), "/format", 1), "/format", "a string is needed");
}

TEST_CASE("required fields may not be missing") {
  for (const std::string field : {"id", "dimension", "points", "constraints"}) {
    check_refused(with(plane(), "/" + field, nullptr), "", "'" + field + "' is missing");
  }
  for (const std::string field : {"type", "between", "length"}) {
    check_refused(with(plane(), "/constraints/0/" + field, nullptr), "/constraints/0", "is missing");
  }
  for (const std::string field : {"quantity", "convention", "value", "source"}) {
    check_refused(with(plane(), "/published/0/" + field, nullptr), "/published/0",
                  "'" + field + "' is missing");
  }
}

TEST_CASE("unknown fields are refused at every level with the nearest valid name") {
  check_refused(with(plane(), "/sketh", 1), "/sketh", "did you mean 'sketch'?");
  check_refused(with(plane(), "/constraints/1/lenght", 1), "/constraints/1/lenght", "did you mean 'length'?");
  check_refused(with(plane(), "/reference/axle", "p2"), "/reference/axle", "did you mean 'axis'?");
  check_refused(with(plane(), "/interpolation/bnd", 1), "/interpolation/bnd", "did you mean 'bend'?");
  check_refused(with(plane(), "/construction/0/form", 1), "/construction/0/form", "did you mean 'from'?");
  check_refused(with(plane(), "/published/0/origin", "x"), "/published/0/origin", "unknown field");
  check_refused(with(space(), "/sketch/L/directon", 1), "/sketch/L/directon", "did you mean 'direction'?");
  check_refused(with(space(), "/planes", json::array()), "/planes", "planes are not supported");
  check_refused(with(space(), "/angles", json::array()), "/angles", "angles are not supported");
}

TEST_CASE("the id is the name of the file") {
  check_refused(with(plane(), "/id", "other"), "/id", "the file is called 'small'");
  check_refused(with(plane(), "/id", ""), "/id", "empty");
  check_refused(with(plane(), "/id", "a/b"), "/id", "'/'");
  CHECK(gcs::parse_instance(with(plane(), "/id", "other").dump(), "standard input").id == "other");
}

TEST_CASE("the dimension is 2 or 3") {
  check_refused(with(plane(), "/dimension", 4), "/dimension", "give 2 or 3");
  check_refused(with(plane(), "/dimension", 2.5), "/dimension", "2.5");
  check_refused(with(plane(), "/dimension", "2"), "/dimension", "a number is needed");
}

TEST_CASE("names of entities are unique and not empty") {
  check_refused(with(plane(), "/points/2", "p1"), "/points/2", "'p1' is given twice");
  check_refused(with(space(), "/lines/0", "p1"), "/lines/0", "'p1' is given twice");
  check_refused(with(plane(), "/points/0", ""), "/points/0", "empty");
  check_refused(with(plane(), "/points/0", 1), "/points/0", "a string is needed");
  check_refused(with(plane(), "/points", json::array()), "/points", "no point");
  check_refused(with(plane(), "/lines", {"L"}), "/lines", "space only");
  json crowd = plane();
  for (int i = 0; i < 2000; ++i) crowd["points"].push_back("q" + std::to_string(i));
  check_refused(crowd, "/points", "up to 2000");
}

TEST_CASE("constraints name two different known entities") {
  check_refused(with(plane(), "/constraints/0/between/1", "q2"), "/constraints/0/between/1",
                "did you mean 'p2'?");
  check_refused(with(plane(), "/constraints/0/between/1", "p1"), "/constraints/0/between",
                "distance to itself");
  check_refused(with(plane(), "/constraints/0/between", {"p1"}), "/constraints/0/between", "exactly 2");
  json two_lines = with(space(), "/lines", {"L", "M"});
  two_lines["constraints"][0]["between"] = {"L", "M"};
  check_refused(two_lines, "/constraints/0/between", "between two lines");
}

TEST_CASE("only distances are known") {
  check_refused(with(plane(), "/constraints/0/type", "angle"), "/constraints/0/type",
                "only known type is 'distance'");
  check_refused(with(plane(), "/constraints/0/type", "incidence"), "/constraints/0/type",
                "distance of length 0");
}

TEST_CASE("a constraint has one length, and it is positive") {
  check_refused(with(plane(), "/constraints/0/squared", 9), "/constraints/0", "both 'length' and 'squared'");
  check_refused(with(plane(), "/constraints/0/length", 0), "/constraints/0/length", "> 0");
  check_refused(with(plane(), "/constraints/0/length", -3), "/constraints/0/length", "-3");
  check_refused(with(plane(), "/constraints/1/squared", -1e-300), "/constraints/1/squared", "> 0");
  check_refused(with(plane(), "/constraints/0/length", "3"), "/constraints/0/length", "a number is needed");
  check_refused(with(space(), "/constraints/6/length", -1), "/constraints/6/length", "≥ 0");
}

TEST_CASE("constraints have different ids and different ends") {
  check_refused(with(plane(), "/constraints/2/id", "a1"), "/constraints/2", "'a1' is taken");
  check_refused(with(plane(), "/constraints/2/id", ""), "/constraints/2/id", "empty");
  check_refused(with(plane(), "/constraints/2/between", {"p2", "p1"}), "/constraints/2",
                "'a1' and 'a3' both");
  check_refused(with(plane(), "/constraints", json::array()), "/constraints", "no constraint");
}

TEST_CASE("structural defects are refused with all names and a remedy") {
  check_refused(with(plane(), "/constraints/2", nullptr), "/constraints", "under-constrained");
  json four = bipyramid();
  four["constraints"].push_back({{"type", "distance"}, {"between", {"p5", "p4"}}, {"length", 1}});
  check_refused(four, "/constraints", "over-constrained");
  check_refused(with(plane(), "/constraints/2/length", 8), "/constraints/2", "a3 (p2–p3) is 8");
}

TEST_CASE("an argument is a file, a shipped id or standard input") {
  CHECK(gcs::load_instance("k33").problem.points.size() == 6);
  CHECK_THAT(message_of("prizm"), Catch::Contains("'prizm'") && Catch::Contains("did you mean 'prism'?"));
  CHECK_THAT(message_of("schema"), Catch::Contains("no shipped instance of this id"));
  CHECK_THAT(message_of(""), Catch::Contains("no shipped instance of this id"));
  CHECK_THAT(message_of("/no/such/file.json"),
             Catch::Equals("/no/such/file.json: there is no such file; give a file, "
                           "the id of a shipped instance, or -"));
  CHECK_THAT(message_of("no-such-file.json"), Catch::Contains("there is no such file"));
  CHECK_THAT(message_of(GCSBENCH_SOURCE_DIR "/instances"), Catch::Contains("directory"));
}

TEST_CASE("files are read, compared with their names and refused when empty") {
  const TemporaryFolder folder;
  CHECK(gcs::load_instance(folder.write("small.json", plane().dump())).id == "small");
  CHECK_THAT(message_of(folder.write("large.json", plane().dump())),
             Catch::Contains("the file is called 'large'"));
  CHECK_THAT(message_of(folder.write("small.json", "")), Catch::Contains("the input is empty"));
  CHECK_THAT(message_of(folder.write("small.json", "{")), Catch::Contains("small.json: line 1, column 2"));
}
