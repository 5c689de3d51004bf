/// A type of constraint that is one file is read, solved and spoken of, without a line elsewhere.

#include <catch2/catch.hpp>
#include <string>

#include "solvers/reading/instance_parser.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/solving/solve.hpp"

using namespace gcs;

namespace {

/// Points a, b, c on a circle around p, with further constraints.
Instance on_a_circle(const std::string& constraints) {
  return parse_instance(R"({"format": "gcsbench-instance/2", "id": "circle", "dimension": 2,
    "reference": {"origin": "p", "axis": "c"},
    "points": ["a", "b", "c", "p"], "constraints": [
    {"type": "equidistant", "between": ["p", ["a", "b"]]}, {"type": "equidistant", "between": ["p", ["b", "c"]]})" +
                        constraints + "]}");
}

std::string distance(const std::string& from, const std::string& to, const std::string& length) {
  return R"(, {"type": "distance", "between": [")" + from + R"(", ")" + to + R"("], "length": )" + length +
         "}";
}

const std::string chords = distance("a", "b", "3") + distance("b", "c", "4");

std::string refusal(const std::string& constraints) {
  try {
    on_a_circle(constraints);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

// On a circle of given radius, c is at its distance from b on the side of a or on the other.
TEST_CASE("a type of constraint in a file of its own is solved") {
  const Instance instance = on_a_circle(chords + distance("p", "a", "2.75"));
  for (const std::string strategy : {"polyhedral", "newton-multistart", "monodromy"}) {
    CAPTURE(strategy);
    const Answer answer = solve(instance, strategy, {}, {.certify = true});
    CAPTURE(answer.reason);
    REQUIRE(answer.solutions.size() == 2);
    for (const auto& solution : answer.solutions) {
      const auto radius = [&](const char* point) {
        return (solution.point(point) - solution.point("p")).norm();
      };
      for (const char* point : {"a", "b", "c"}) CHECK(std::abs(radius(point) - 2.75) < 1e-12);
    }
  }
}

TEST_CASE("messages know a type of constraint in a file of its own") {
  CHECK_THAT(refusal(chords), Catch::Contains("under-constrained"));
  CHECK_THAT(refusal(chords + distance("p", "a", "2.75") + distance("p", "b", "2.75")),
             Catch::Contains("over-constrained"));
  CHECK_THAT(
      refusal(R"(, {"type": "equidistant", "between": ["p", "a"]})"),
      Catch::Contains("'equidistant' is not between point–point; 'equidistant' is between point–segment"));
  CHECK_THAT(refusal(R"(, {"type": "equidistant", "between": ["p", ["b", "a"]]})"),
             Catch::Contains("keep one"));
  CHECK_THAT(refusal(R"(, {"type": "equidistanz", "between": ["p", ["a", "b"]]})"),
             Catch::Contains("did you mean 'equidistant'?"));
}
