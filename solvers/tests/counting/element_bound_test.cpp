/// Bounds of elements placed one set after the other against numbers of solutions that geometry gives. The certificate
/// tests hold every bound against that of scripts/check-certificate, which shares nothing with this.

#include "solvers/counting/element_bound.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/reading/instance_parser.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"

using namespace gcs;

namespace {

ProblemStatement general_scene(const std::string& elements, const std::string& constraints) {
  return parse_instance(R"({"format": "gcsbench-instance/2", "id": "scene", "title": "A scene", )" +
                        elements + R"(, "constraints": [)" + constraints + "]}")
      .problem;
}

std::string distance(const std::string& a, const std::string& b, const std::string& length) {
  return R"({"type": "distance", "between": [")" + a + R"(", ")" + b + R"("], "length": )" + length + "}";
}

std::string stated(const std::string& type, const std::string& a, const std::string& b) {
  return R"({"type": ")" + type + R"(", "between": [")" + a + R"(", ")" + b + R"("]})";
}

const std::string triangle =
    distance("p", "q", "3") + ", " + distance("q", "r", "2.5") + ", " + distance("r", "p", "2");

/// Through p, and on two cones about it: 4, in two pairs of mirror images.
const std::string line_on_cones =
    ", " + stated("on", "p", "K") + ", " + distance("q", "K", "1.2") + ", " + distance("K", "r", "0.8");

/// Perpendicular to E, which is parallel to both lines and at a distance from a point: 2, and then 4 on the sides of each.
ProblemStatement upright_line() {
  return general_scene(
      R"("dimension": 3, "points": ["p"], "lines": ["K", "g", "h"], "planes": ["E"], "fixed": {"p": [0.4, 0.1, 0.3],
         "g": {"point": [0, 0, 0], "direction": [1, 0.2, 0.3]}, "h": {"point": [0.2, 0, 1], "direction": [-0.1, 1, 0.4]}})",
      stated("parallel", "g", "E") + ", " + stated("parallel", "h", "E") + ", " + distance("p", "E", "0.5") +
          ", " + stated("perpendicular", "K", "E") + ", " + distance("K", "g", "0.7") + ", " +
          distance("K", "h", "0.9"));
}

/// 2 for the sides of ab, 2 for those of bc; a mirror image and a half-turn, of which the frame leaves the first.
ProblemStatement rectangle() {
  std::string constraints = distance("a", "b", "3") + ", " + distance("b", "c", "2");
  for (const auto& [line, from, to] :
       {std::array{"ab", "a", "b"}, {"bc", "b", "c"}, {"cd", "c", "d"}, {"da", "d", "a"}})
    constraints += ", " + stated("on", from, line) + ", " + stated("on", to, line);
  for (const auto& [one, other] : {std::array{"ab", "bc"}, {"bc", "cd"}, {"cd", "da"}})
    constraints += ", " + stated("perpendicular", one, other);
  return general_scene(R"("dimension": 2, "points": ["a", "b", "c", "d"], "lines": ["ab", "bc", "cd", "da"])",
                       constraints);
}

/// At most, of a body whose legs from points a1 to a6 of another one end in these.
Natural postures(const std::string& b1, const std::string& b2, const std::string& b3, const std::string& b4,
                 const std::string& b5, const std::string& b6) {
  std::string legs;
  for (const auto& [a, b] : {std::pair{"a1", b1}, {"a2", b2}, {"a3", b3}, {"a4", b4}, {"a5", b5}, {"a6", b6}})
    legs += (legs.empty() ? "" : ", ") + distance(a, b, "1.5");
  return ways_to_place(placed_sets(general_scene(R"("dimension": 3, "points": [], "bodies": {
      "base": {"a1": [0, 0, 0], "a2": [1.7, 0.1, 0.2], "a3": [0.4, 1.5, -0.3], "a4": [1.2, -0.8, 0.1], "a5": [-0.4, 0.6, 0.5],
               "a6": [0.9, 0.7, -0.2]},
      "top": {"b1": [0.3, 0.7, 0.2], "b2": [0.2, -0.5, 0.6], "b3": [0.5, 1.1, 0.4], "b4": [1.2, 0.8, 0.3], "b5": [0.8, -0.1, 0.9],
              "b6": [-0.5, 0.4, -0.6]}})",
                                                 legs))
                           .value());
}

/// Proven to be all, as so many figures and no more are possible.
void check_proven(const ProblemStatement& problem, std::uint64_t figures, std::size_t classes) {
  CHECK(ways_to_place(placed_sets(problem).value()) == Natural(figures));
  const Answer answer = solve(Scene(problem), Monodromy{.certify = true});
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.solutions.size() == classes);
  CHECK(answer.proofs.value().are_complete());
  CHECK(answer.proofs->with_image == (figures == classes ? 0 : classes));
}

}  // namespace

TEST_CASE("elements have as many places as conics, cones and sides leave them") {
  check_proven(
      general_scene(R"("dimension": 3, "points": ["p", "q", "r"], "lines": ["K"])", triangle + line_on_cones),
      4, 2);
  check_proven(rectangle(), 2, 1);
}

TEST_CASE("a platform has fewer postures where its legs end in three points of one body") {
  // 40 in general (Ronga, Vust 1992). In pairs a triangle with its corners on circles: 2 · 2 · 2 for either way round it.
  // Where three of them meet there are 2 places for the first corner, 2 for that with two, 2 for the last.
  CHECK(postures("b1", "b2", "b3", "b4", "b5", "b6") == Natural(40));
  CHECK(postures("b1", "b1", "b2", "b2", "b3", "b3") == Natural(16));
  CHECK(postures("b1", "b1", "b1", "b2", "b2", "b3") == Natural(8));
}

TEST_CASE("a line that is held upright may be at a distance from lines that it does not run along") {
  const ProblemStatement problem = upright_line();
  CHECK(ways_to_place(placed_sets(problem).value()) == Natural(8));
  const Answer answer = solve(Scene(problem), Monodromy{.certify = true});
  CHECK(answer.solutions.size() == 8);
  CHECK(answer.proofs.value().are_complete());
}

TEST_CASE("figures that may be their own mirror images are not divided by two") {
  // On the line through p and q, in the plane of the triangle.
  const ProblemStatement problem =
      general_scene(R"("dimension": 3, "points": ["p", "q", "r", "t"], "lines": ["K"])",
                    triangle + ", " + stated("on", "p", "K") + ", " + stated("on", "q", "K") + ", " +
                        stated("on", "t", "K") + ", " + distance("t", "r", "1.8"));
  check_proven(problem, 2, 2);
  CHECK(theoretical_counts(problem).bound->count.up_to_reflection() == Natural(2));
}

TEST_CASE("where something is not between two elements, or may be moved, no sets are known") {
  CHECK_FALSE(placed_sets(
      general_scene(R"("dimension": 3, "points": ["p", "q", "r", "t"])",
                    triangle + ", " + distance("p", "t", "2") + ", " + distance("q", "t", "2") +
                        R"(, {"type": "angle", "between": [["p", "q"], ["r", "t"]], "degrees": 70})")));
  CHECK_FALSE(placed_sets(
      general_scene(R"("dimension": 3, "points": ["p", "q", "r"], "lines": ["K"], "fixed": {"p": [0, 0, 0]})",
                    triangle + line_on_cones)));
}
