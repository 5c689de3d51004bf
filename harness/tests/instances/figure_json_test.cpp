#include "solvers/reading/figure_json.hpp"

#include <catch2/catch.hpp>

using namespace gcs;

namespace {

const std::string file = "file.json";

ProblemStatement two_points_and_a_line(int dimension) {
  ProblemStatement problem;
  problem.dimension = dimension;
  problem.points = {"a", "b"};
  if (dimension == 3) problem.lines = {"L"};
  return problem;
}

/// Reads the figure and writes it again, its planes where it has some.
std::string copy(const std::string& text, const ProblemStatement& problem, bool is_real) {
  const JsonValue document = parse_json(text, file);
  const Figure figure = read_figure(JsonCursor(document, file), problem, is_real);
  CHECK(figure.is_real() == is_real);
  JsonMembers members{{"points", json_points(problem, figure)}, {"lines", json_lines(problem, figure)}};
  if (!problem.planes.empty()) members.emplace_back("planes", json_planes(problem, figure));
  return to_text(json_object(std::move(members)), -1);
}

std::string copy(const std::string& text, int dimension, bool is_real) {
  return copy(text, two_points_and_a_line(dimension), is_real);
}

}  // namespace

TEST_CASE("a figure that is read and written stays the same") {
  const std::string real = R"({"points": {"a": [0, 0.1, 1e-300], "b": [1, 2, 3]}, )"
                           R"("lines": {"L": {"point": [0, 0, 5], "direction": [0, 3, 4]}}})";
  const std::string complex =
      R"({"points": {"a": [[0, 1], [0.1, -2], [3, 0]], "b": [[1, 1], [2, 2], [3, 3]]}, )"
      R"("lines": {"L": {"point": [[0, 1], [0, 0], [5, 0]], "direction": [[0, 1], [3, 0], [4, 0.5]]}}})";
  CHECK(copy(real, 3, true) == real);
  CHECK(copy(complex, 3, false) == complex);
}

TEST_CASE("planes of a figure that is read and written stay the same") {
  ProblemStatement problem;
  problem.planes = {"E", "F"};
  const std::string real =
      R"({"points": {}, "lines": {}, "planes": {"E": {"normal": [0, 0.6, 0.8], "offset": -2}, )"
      R"("F": {"normal": [1, 0, 0], "offset": 0}}})";
  const std::string complex =
      R"({"points": {}, "lines": {}, "planes": {"E": {"normal": [[0, 1], [0.5, 0], [-1, 2]], "offset": [1, -3]}, )"
      R"("F": {"normal": [[1, 0], [0, 0], [0, 0]], "offset": [0, 0.5]}}})";
  CHECK(copy(real, problem, true) == real);
  CHECK(copy(complex, problem, false) == complex);
  CHECK_THROWS_WITH(copy(R"({"points": {}, "planes": {"E": {"normal": [1, 0, 0]}}})", problem, true),
                    "file.json: /planes/E: the field 'offset' is missing; add it");
}

TEST_CASE("lines of the plane have two coordinates") {
  ProblemStatement problem = two_points_and_a_line(2);
  problem.lines = {"L"};
  const std::string text =
      R"({"points": {"a": [1, 2], "b": [3, 4]}, "lines": {"L": {"point": [0, 5], "direction": [0.6, 0.8]}}})";
  CHECK(copy(text, problem, true) == text);
}

TEST_CASE("a figure of the plane has two coordinates and needs no lines") {
  CHECK(copy(R"({"points": {"b": [3, 4], "a": [1, 2]}})", 2, true) ==
        R"({"points": {"a": [1, 2], "b": [3, 4]}, "lines": {}})");
}

TEST_CASE("what is wrong with a figure is said with its place") {
  const auto check_refused = [](const std::string& text, bool is_real, const std::string& message) {
    CHECK_THROWS_WITH(copy(text, 2, is_real), "file.json: " + message);
  };
  check_refused(R"({"points": {"a": [1, 2]}})", true, "/points: the field 'b' is missing; add it");
  check_refused(R"({"points": {"a": [1, 2], "b": [3]}})", true,
                "/points/b: there are 1 elements; give exactly 2 coordinates");
  check_refused(R"({"points": {"a": [[1, 0]]}})", false,
                "/points/a: there are 1 elements; give exactly 2 complex coordinates [re, im]");
  check_refused(R"({"points": {"a": [[1, 0], [1, 2, 3]]}})", false,
                "/points/a/1: this is no complex number; give [re, im]");
  check_refused(R"({"points": {"a": [[1, "0"], [1, 2]]}})", false,
                "/points/a/0/1: this is a string; a number is needed");
}
