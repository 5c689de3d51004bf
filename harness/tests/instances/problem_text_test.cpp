/// What an external program gets to read is the problem, the whole problem and nothing but the problem.

#include "harness/instances/problem_text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "harness/instances/families.hpp"
#include "harness/instances/instance_lookup.hpp"

using namespace gcs;

namespace {

bool same(const PlanePosition& a, const PlanePosition& b) {
  return (a.normal - b.normal).norm() <= 1e-15 && std::abs(a.offset - b.offset) <= 1e-15 * std::abs(a.offset);
}

bool same(const LinePosition& a, const LinePosition& b) {
  return (a.point - b.point).norm() <= 1e-15 * a.point.norm() && (a.direction - b.direction).norm() <= 1e-15;
}

void check_same_bodies(const ProblemStatement& a, const ProblemStatement& b) {
  REQUIRE(a.bodies.size() == b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    CHECK(a.bodies[i].name == b.bodies[i].name);
    REQUIRE(a.bodies[i].elements.size() == b.bodies[i].elements.size());
    for (std::size_t j = 0; j < a.bodies[i].elements.size(); ++j) {
      const BodyElement &one = a.bodies[i].elements[j], &other = b.bodies[i].elements[j];
      CHECK(one.entity == other.entity);
      REQUIRE(one.numbers.size() == other.numbers.size());
      for (std::size_t k = 0; k < one.numbers.size(); ++k)
        CHECK(one.numbers[k].text == other.numbers[k].text);
    }
  }
  CHECK(a.reference_body == b.reference_body);
}

void check_same_relations(const ProblemStatement& a, const ProblemStatement& b) {
  REQUIRE(a.relations.size() == b.relations.size());
  for (std::size_t i = 0; i < a.relations.size(); ++i) {
    CHECK(a.relations[i].id == b.relations[i].id);
    CHECK(a.relations[i].type == b.relations[i].type);
    CHECK(a.relations[i].of == b.relations[i].of);
    CHECK(a.relations[i].form == b.relations[i].form);
    CHECK(a.relations[i].given.text == b.relations[i].given.text);
    CHECK(a.relations[i].sign == b.relations[i].sign);
  }
}

void check_same(const ProblemStatement& a, const ProblemStatement& b) {
  check_same_bodies(a, b);
  check_same_relations(a, b);
  CHECK(a.planes == b.planes);
  CHECK(a.dimension == b.dimension);
  CHECK(a.points == b.points);
  CHECK(a.lines == b.lines);
  CHECK(a.fixed_points == b.fixed_points);
  const bool has_fixed = std::any_of(a.fixed_points.begin(), a.fixed_points.end(),
                                     [](const auto& position) { return position.has_value(); });
  if (has_fixed) CHECK(a.fixed_texts == b.fixed_texts);
  REQUIRE(a.constraints.size() == b.constraints.size());
  for (std::size_t i = 0; i < a.constraints.size(); ++i) {
    CHECK(a.constraints[i].id == b.constraints[i].id);
    CHECK(a.constraints[i].between == b.constraints[i].between);
    CHECK(a.constraints[i].given.text == b.constraints[i].given.text);
    CHECK(a.constraints[i].is_squared == b.constraints[i].is_squared);
  }
  REQUIRE(a.sketch.has_value() == b.sketch.has_value());
  if (a.sketch) {
    CHECK(a.sketch->points == b.sketch->points);
    REQUIRE(a.sketch->lines.size() == b.sketch->lines.size());
    for (std::size_t i = 0; i < a.sketch->lines.size(); ++i)
      CHECK(same(a.sketch->lines[i], b.sketch->lines[i]));
    REQUIRE(a.sketch->planes.size() == b.sketch->planes.size());
    for (std::size_t i = 0; i < a.sketch->planes.size(); ++i)
      CHECK(same(a.sketch->planes[i], b.sketch->planes[i]));
    CHECK(a.interpolation.bent == b.interpolation.bent);
    CHECK(a.interpolation.bend == b.interpolation.bend);
    REQUIRE(a.interpolation.bends.has_value() == b.interpolation.bends.has_value());
    if (a.interpolation.bends) {
      REQUIRE(a.interpolation.bends->size() == b.interpolation.bends->size());
      for (std::size_t i = 0; i < a.interpolation.bends->size(); ++i) {
        CHECK((*a.interpolation.bends)[i].constraint == (*b.interpolation.bends)[i].constraint);
        CHECK((*a.interpolation.bends)[i].coefficients == (*b.interpolation.bends)[i].coefficients);
      }
    }
  }
  REQUIRE(a.construction.size() == b.construction.size());
  for (std::size_t i = 0; i < a.construction.size(); ++i) {
    CHECK(a.construction[i].place == b.construction[i].place);
    REQUIRE(a.construction[i].from.size() == b.construction[i].from.size());
    for (std::size_t j = 0; j < a.construction[i].from.size(); ++j) {
      CHECK(a.construction[i].from[j].from == b.construction[i].from[j].from);
      CHECK(a.construction[i].from[j].constraint == b.construction[i].from[j].constraint);
      CHECK(a.construction[i].from[j].driving == b.construction[i].from[j].driving);
    }
  }
}

void check_read_back(const Instance& instance) {
  INFO(instance.id);
  const Scene scene = instance;
  const std::string text = problem_text(scene);
  const Instance again = parse_instance(text, "text");
  check_same(instance.problem, again.problem);
  const Scene scene_again = again;
  CHECK(scene_again.reference().origin == scene.reference().origin);
  CHECK(scene_again.reference().axis == scene.reference().axis);
  CHECK(scene_again.reference().plane == scene.reference().plane);
  CHECK(scene_again.reference().line == scene.reference().line);
  CHECK(scene_again.reference().height == scene.reference().height);
  CHECK(scene_again.target_lengths() == scene.target_lengths());
  CHECK(text.find("published") == std::string::npos);
  CHECK(text.find("\"id\": \"" + instance.id + '"') == std::string::npos);
}

}  // namespace

TEST_CASE("the text of a problem reads back as the same problem") {
  for (const std::string& id : shipped_instances()) check_read_back(load_instance(id));
}

TEST_CASE("lengths of many digits keep them in a problem's text") {
  for (const char* family : {"scale-of-ten", "short-edge", "coplanar-centres"})
    for (const std::string& member : find_family(family)->members()) check_read_back(load_member(member));
}

TEST_CASE("a given construction plan is part of a problem's text") {
  const Instance with_plan = parse_instance(
      R"({"format": "gcsbench-instance/1", "id": "plan", "dimension": 2, "points": ["a", "b", "c", "d"],
          "constraints": [{"type": "distance", "between": ["a", "b"], "length": 1},
                          {"type": "distance", "between": ["b", "c"], "length": 1},
                          {"type": "distance", "between": ["c", "d"], "length": 1},
                          {"type": "distance", "between": ["d", "a"], "length": 1},
                          {"type": "distance", "between": ["a", "c"], "length": 1.5}],
          "sketch": {"a": [0, 0], "b": [1, 0], "c": [1, 1], "d": [0, 1]},
          "interpolation": {"bent": "a3", "bend": 1},
          "construction": [{"place": "a", "from": []}, {"place": "b", "from": [["a", "a1"]]},
                           {"place": "c", "from": [["a", "k1"], ["b", "a2"]]},
                           {"place": "d", "from": [["c", "a3"], ["a", "a4"]]}]})",
      "plan", "");
  REQUIRE(with_plan.problem.construction.size() == 4);
  check_read_back(with_plan);
}

TEST_CASE("planes, bodies and relations are part of a problem's text") {
  const Instance scene = parse_statement(
      R"({"format": "gcsbench-instance/2", "id": "all", "dimension": 3, "points": ["p"], "lines": ["L"],
          "planes": ["E"],
          "bodies": {"one": {"q": [0, 0, 0.50], "r": [1, 0, 0], "s": [0, 1, 0],
                             "M": {"point": [1, 2, 3], "direction": [0, 0, 2]}},
                     "two": {"q": [0, 0, 0], "u": [0, 1, 0], "F": {"normal": [0.1, 0, 0], "offset": -7},
                             "N": {"point": [0, 1, 1], "direction": [1, 0, 0]}}},
          "constraints": [{"type": "distance", "between": ["p", "E"], "length": -2.50},
                          {"type": "distance", "between": ["r", "p"], "squared": 2},
                          {"type": "distance", "between": ["L", "M"], "squared": 3.0},
                          {"type": "angle", "between": ["E", "F"], "degrees": 120},
                          {"type": "angle", "between": [["p", "q"], "L"], "cosine": 0.10},
                          {"type": "meet", "between": ["L", "N"]},
                          {"type": "collinear", "between": ["p", "r", "u"]},
                          {"type": "orientation", "of": ["p", "q", "r", "u"], "sign": -1}],
          "reference": {"body": "two"}})",
      "all", "");
  REQUIRE(scene.problem.relations.size() == 7);
  const Instance again = parse_statement(problem_text(Scene::unchecked(scene.problem)), "text");
  check_same(scene.problem, again.problem);
}

TEST_CASE("bends by polynomials, and that nothing is bent, are part of a problem's text") {
  Instance instance = load_instance("k33");
  instance.problem.interpolation.bends = {{7, {0.1, -2.5e-3, 1.0 / 3}}, {2, {}}};
  check_read_back(instance);
  instance.problem.interpolation.bends.emplace();
  check_read_back(instance);
}
