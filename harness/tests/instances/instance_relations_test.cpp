/// gcsbench-instance/2: constraints of all types. Expected values are those of the files and of elementary geometry.

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "harness/tests/instances/general_samples.hpp"
#include "harness/tests/instances/instance_samples.hpp"

namespace {

using namespace gcs::samples;
using gcs::Operand;
using gcs::ProblemStatement;
using gcs::Relation;
using nlohmann::json;

const std::map<std::string, std::string> operand_samples{
    {"point", R"("p1")"}, {"line", R"("L")"}, {"plane", R"("E")"}, {"segment", R"(["p2", "p3"])"}};
const std::map<std::string, std::string> other_samples{
    {"point", R"("p4")"}, {"line", R"("M")"}, {"plane", R"("F")"}, {"segment", R"(["p3", "p4"])"}};

/// With exactly these digits, which a document of doubles would round.
Relation angle_of(const std::string& a, const std::string& b, const std::string& form,
                  const std::string& number) {
  const std::string rounded = "0.8125";
  std::string text = and_also(scene(), between("angle", a, b, ", \"" + form + "\": " + rounded)).dump();
  text.replace(text.find(rounded), rounded.size(), number);
  return gcs::parse_statement(text, "small.json", "small").problem.relations.back();
}

}  // namespace

TEST_CASE("constraints are told apart, in the order of the file, and have ids by their place in it") {
  const ProblemStatement problem = parsed(json::parse(R"({
    "format": "gcsbench-instance/2", "id": "small", "dimension": 3,
    "points": ["p1", "p2", "p3", "p4"], "lines": ["L"], "planes": ["E"],
    "constraints": [
      {"type": "on", "between": ["p1", "E"]},
      {"type": "distance", "between": ["L", "p2"], "length": 1.5},
      {"type": "angle", "between": [["p1", "p2"], "E"], "degrees": 30},
      {"type": "distance", "between": ["p2", "p1"], "squared": 2},
      {"id": "side", "type": "orientation", "of": ["p4", "p3", "p2", "p1"], "sign": -1},
      {"type": "collinear", "between": ["p3", "p1", "p2"]},
      {"type": "distance", "between": ["p3", "E"], "length": -2.5}]})"))
                                       .problem;
  REQUIRE(problem.constraints.size() == 2);
  CHECK(problem.constraints[0].id == "a2");
  CHECK(problem.constraints[0].between == std::array{4, 1});
  CHECK(problem.constraints[0].given.text == "1.5");
  CHECK(problem.constraints[1].id == "a4");
  CHECK(problem.constraints[1].is_squared);
  REQUIRE(problem.relations.size() == 5);
  CHECK(problem.relations[0].id == "a1");
  CHECK(problem.relations[0].type == "on");
  CHECK(problem.relations[0].of == std::vector<Operand>{{0, -1}, {5, -1}});
  CHECK(problem.relations[0].form == Relation::Form::none);
  CHECK(problem.relations[1].id == "a3");
  CHECK(problem.relations[1].of == std::vector<Operand>{{0, 1}, {5, -1}});
  CHECK(problem.relations[1].form == Relation::Form::degrees);
  CHECK(problem.relations[1].given.text == "30");
  CHECK(problem.relations[2].id == "side");
  CHECK(problem.relations[2].of == std::vector<Operand>{{3, -1}, {2, -1}, {1, -1}, {0, -1}});
  CHECK(problem.relations[2].sign == -1);
  CHECK(problem.relations[3].type == "collinear");
  CHECK(problem.relations[3].of == std::vector<Operand>{{2, -1}, {0, -1}, {1, -1}});
  CHECK(problem.relations[4].form == Relation::Form::length);
  CHECK(problem.relations[4].given.value == -2.5);
}

TEST_CASE("each type takes the pairs of its table and refuses all others by name") {
  using Pairs = std::set<std::set<std::string>>;
  const Pairs directions{{"line"},          {"segment", "line"},  {"segment"},
                         {"line", "plane"}, {"segment", "plane"}, {"plane"}};
  const std::map<std::string, std::pair<Pairs, std::string>> table{
      {"distance",
       {{{"point"}, {"point", "line"}, {"point", "plane"}, {"line"}, {"line", "plane"}, {"plane"}},
        R"(, "length": 1)"}},
      {"angle", {directions, R"(, "degrees": 10)"}},
      {"on", {{{"point", "line"}, {"point", "plane"}, {"line", "plane"}}, ""}},
      {"meet", {{{"line"}}, ""}},
      {"parallel", {directions, ""}},
      {"perpendicular", {directions, ""}}};
  for (const auto& [type, entry] : table) {
    const auto& [pairs, value] = entry;
    for (const auto& [a, first] : operand_samples) {
      for (const auto& [b, second] : other_samples) {
        const std::string constraint = between(type, first, second, value);
        INFO(constraint);
        // Where only parallel elements have a distance they are made so.
        const bool as_parallels = type == "distance" && a != "point" && b != "point";
        const json document = as_parallels ? and_also(scene(), between("parallel", first, second)) : scene();
        if (pairs.contains({a, b})) {
          const ProblemStatement problem = parsed(and_also(document, constraint)).problem;
          CHECK(problem.constraints.size() + problem.relations.size() == (as_parallels ? 2 : 1));
        } else if (!as_parallels || (a != "segment" && b != "segment")) {
          check_constraint_refused(
              document, constraint, "/between",
              "'" + type + "' is not between " + a + "–" + b + "; '" + type + "' is between ");
        }
      }
    }
  }
  check_constraint_refused(scene(), between("on", R"("L")", R"("M")"), "/between",
                           "'on' is between point–line, point–plane and line–plane");
  check_constraint_refused(plane_scene(), between("on", R"("L")", R"("M")"), "/between",
                           "'on' is between point–line");
  check_constraint_refused(scene(), between("distance", R"(["p1", "p2"])", R"("M")", R"(, "length": 1)"),
                           "/between", "'distance' is not between segment–line");
}

TEST_CASE("names in constraints are known, and different") {
  check_constraint_refused(scene(), between("on", R"("p1")", R"("G")"), "/between/1",
                           "no point, line or plane 'G'");
  check_constraint_refused(scene(), between("parallel", R"(["p1", "L"])", R"("M")"), "/between/0/1",
                           "'L' is a line; name a point");
  check_constraint_refused(scene(), between("parallel", R"(["p1", "p1"])", R"("M")"), "/between/0",
                           "'p1' for both ends");
  check_constraint_refused(scene(), between("parallel", R"(["p1", "p2", "p3"])", R"("M")"), "/between/0",
                           "exactly 2");
  check_constraint_refused(scene(), between("parallel", R"(["p1", "p2"])", R"(["p2", "p1"])"), "/between",
                           "'p1–p2' is on both sides of 'parallel'");
  check_constraint_refused(scene(), between("distance", R"("E")", R"("E")", R"(, "length": 1)"), "/between",
                           "'E' has no distance to itself");
  check_constraint_refused(scene(), R"({"type": "meet", "between": ["L"]})", "/between", "exactly 2");
  check_constraint_refused(bodies(), between("on", R"("q")", R"("base")"), "/between/1",
                           "'base' is a body; name one of its elements");
  check_constraint_refused(scene(), R"({"type": "collinear", "between": ["p1", "p2"]})", "/between",
                           "3 points or more");
  check_constraint_refused(scene(), R"({"type": "coplanar", "between": ["p1", "p2", "p3"]})", "/between",
                           "4 points or more");
  check_constraint_refused(scene(), R"({"type": "collinear", "between": ["p1", "p2", "E"]})", "/between/2",
                           "'E' is a plane; name a point");
  check_constraint_refused(scene(), R"({"type": "collinear", "between": ["p1", "p2", "p1"]})", "/between/2",
                           "'p1' is named twice");
  check_constraint_refused(scene(), R"({"type": "angel", "between": ["L", "M"]})", "/type",
                           "did you mean 'angle'? The types are 'distance', 'angle', 'on'");
  check_constraint_refused(scene(), between("on", R"("p1")", R"("L")", R"(, "length": 0)"), "/length",
                           "unknown field 'length'");
}

TEST_CASE("distances have the values that make them distances") {
  const auto refused = [](const json& document, const std::string& a, const std::string& b,
                          const std::string& value, const std::string& member, const std::string& word) {
    check_constraint_refused(document, between("distance", a, b, value), member, word);
  };
  const std::string zero = R"(, "length": 0)", minus = R"(, "length": -1)", square = R"(, "squared": 4)";
  refused(scene(), R"("p1")", R"("p2")", zero, "/length", "> 0");
  refused(scene(), R"("p1")", R"("L")", zero, "/length", "'on'");
  refused(scene(), R"("E")", R"("p1")", zero, "/length", "'on'");
  refused(scene(), R"("L")", R"("M")", zero, "/length", "'meet'");
  const json with_parallel = and_also(scene(), between("parallel", R"("L")", R"("E")"));
  refused(with_parallel, R"("E")", R"("L")", zero, "/length", "'on'");
  refused(with_parallel, R"("E")", R"("L")", minus, "/length", "no sign");
  refused(scene(), R"("E")", R"("F")", zero, "/length", "name it once");
  refused(plane_scene(), R"("M")", R"("L")", zero, "/length", "name it once");
  refused(scene(), R"("p1")", R"("p2")", minus, "/length", "> 0");
  refused(scene(), R"("p1")", R"("L")", minus, "/length", "> 0");
  refused(scene(), R"("M")", R"("L")", minus, "/length", "> 0");
  refused(scene(), R"("p1")", R"("E")", square, "/squared", "give 'length'");
  refused(scene(), R"("F")", R"("E")", square, "/squared", "give 'length'");
  refused(scene(), R"("p1")", R"("E")", R"(, "length": -1e-310)", "/length", "full precision");
  refused(scene(), R"("p1")", R"("E")", zero + square, "", "both 'length' and 'squared'");
  refused(scene(), R"("p1")", R"("E")", "", "", "the length is missing");
}

TEST_CASE("only parallels give lines of the plane, a plane and a line, and planes a distance") {
  const std::string length = R"(, "length": 2)";
  const std::string needed = "no 'parallel' joins";
  check_constraint_refused(scene(), between("distance", R"("E")", R"("F")", length), "/between", needed);
  check_constraint_refused(scene(), between("distance", R"("L")", R"("F")", length), "/between", needed);
  check_constraint_refused(plane_scene(), between("distance", R"("L")", R"("M")", length), "/between",
                           needed);
  CHECK(relation_of(scene(), between("distance", R"("L")", R"("M")", length)).given.value == 2);
  SECTION("by way of others, and in any order of the file") {
    json document = and_also(scene(), between("distance", R"("M")", R"("F")", R"(, "squared": 2)"));
    document = and_also(document, between("parallel", R"("L")", R"(["p2", "p1"])"));
    document = and_also(document, between("parallel", R"(["p1", "p2"])", R"("M")"));
    check_refused(document, "/constraints/0/between", needed);
    document = and_also(document, between("parallel", R"("L")", R"("E")"));
    check_refused(document, "/constraints/0/between", needed);
    document = and_also(document, between("parallel", R"("E")", R"("F")"));
    CHECK(parsed(document).problem.relations.size() == 5);
    // Two lines that are parallel to one plane may cross.
    const json crossing = json::parse(R"({
      "format": "gcsbench-instance/2", "id": "small", "dimension": 3, "points": [], "planes": ["E", "F", "G"],
      "lines": ["L"], "constraints": [
        {"type": "parallel", "between": ["E", "L"]}, {"type": "parallel", "between": ["L", "F"]},
        {"type": "distance", "between": ["E", "F"], "length": -1}]})");
    check_refused(crossing, "/constraints/2/between", needed);
  }
  SECTION("of planes it has a sign") {
    const json document = and_also(scene(), between("parallel", R"("F")", R"("E")"));
    const Relation relation =
        relation_of(document, between("distance", R"("E")", R"("F")", R"(, "length": -2)"));
    CHECK(relation.given.value == -2);
    CHECK(relation.of == std::vector<Operand>{{6, -1}, {7, -1}});
  }
}

TEST_CASE("angles have the values that make them angles") {
  const auto value = [](const std::string& form, const std::string& number) {
    return ", \"" + form + "\": " + number;
  };
  const auto refused = [&](const std::string& a, const std::string& b, const std::string& form,
                           const std::string& number, const std::string& word) {
    check_constraint_refused(scene(), between("angle", a, b, value(form, number)), "/" + form, word);
  };
  // Directions without a sense.
  for (const auto& [a, b] :
       {std::pair{R"("L")", R"("M")"}, std::pair{R"("L")", R"("E")"}, std::pair{R"("E")", R"(["p1", "p2"])"},
        std::pair{R"(["p1", "p2"])", R"("M")"}}) {
    CHECK(relation_of(scene(), between("angle", a, b, value("degrees", "89.25"))).given.text == "89.25");
    CHECK(relation_of(scene(), between("angle", a, b, value("cosine", "0.25"))).form ==
          Relation::Form::cosine);
    // In doubles the cosines are 1, 1 and 0.
    for (const auto& [form, number] : {std::pair{"degrees", "1e-9"},
                                       {"cosine", "0.99999999999999999999"},
                                       {"degrees", "89.99999999999999999999"}})
      CHECK(angle_of(a, b, form, number).given.text == number);
    CHECK_THROWS_WITH(angle_of(a, b, "degrees", "90.00000000000000000001"),
                      Catch::Contains("above 0 and below 90 degrees"));
    CHECK_THROWS_WITH(angle_of(a, b, "cosine", "1.00000000000000000001"),
                      Catch::Contains("above 0 and below 1"));
    refused(a, b, "degrees", "0", "'parallel'");
    refused(a, b, "degrees", "90", "'perpendicular'");
    refused(a, b, "degrees", "120", "above 0 and below 90 degrees");
    refused(a, b, "degrees", "-1", "above 0 and below 90 degrees");
    refused(a, b, "cosine", "0", "'perpendicular'");
    refused(a, b, "cosine", "1.0", "'parallel'");
    refused(a, b, "cosine", "-0.5", "above 0 and below 1");
    refused(a, b, "cosine", "1.5", "above 0 and below 1");
  }
  // Directions with a sense.
  for (const auto& [a, b] :
       {std::pair{R"("E")", R"("F")"}, std::pair{R"(["p1", "p2"])", R"(["p2", "p3"])"}}) {
    CHECK(relation_of(scene(), between("angle", a, b, value("degrees", "179"))).given.value == 179);
    CHECK(relation_of(scene(), between("angle", a, b, value("cosine", "-0.5"))).given.value == -0.5);
    refused(a, b, "degrees", "0", "'parallel'");
    refused(a, b, "degrees", "90", "'perpendicular'");
    refused(a, b, "degrees", "180", "'parallel'");
    refused(a, b, "degrees", "200", "above 0 and below 180 degrees");
    refused(a, b, "cosine", "-1", "'parallel'");
    refused(a, b, "cosine", "0", "'perpendicular'");
    refused(a, b, "cosine", "-1.1", "above -1 and below 1");
  }
  check_constraint_refused(scene(), between("angle", R"("L")", R"("M")"), "", "the angle is missing");
  check_constraint_refused(scene(), between("angle", R"("L")", R"("M")", R"(, "degrees": 60, "cosine": 0.5)"),
                           "", "both 'degrees' and 'cosine'");
  check_constraint_refused(scene(), between("angle", R"("L")", R"("M")", R"(, "length": 60)"), "/length",
                           "unknown field");
}

TEST_CASE("an orientation is of three points in the plane and four in space") {
  CHECK(relation_of(plane_scene(), R"({"type": "orientation", "of": ["p1", "p2", "p3"], "sign": 1})").sign ==
        1);
  check_constraint_refused(scene(), R"({"type": "orientation", "of": ["p1", "p2", "p3"], "sign": 1})", "/of",
                           "exactly 4 points");
  check_constraint_refused(plane_scene(),
                           R"({"type": "orientation", "of": ["p1", "p2", "p3", "p4"], "sign": 1})", "/of",
                           "exactly 3 points");
  check_constraint_refused(plane_scene(), R"({"type": "orientation", "of": ["p1", "p2", "p1"], "sign": 1})",
                           "/of/2", "named twice");
  check_constraint_refused(plane_scene(), R"({"type": "orientation", "of": ["p1", "p2", "p3"], "sign": 2})",
                           "/sign", "give 1 or -1");
  check_constraint_refused(plane_scene(), R"({"type": "orientation", "of": ["p1", "p2", "p3"]})", "",
                           "'sign' is missing");
  check_constraint_refused(plane_scene(),
                           R"({"type": "orientation", "between": ["p1", "p2", "p3"], "sign": 1})", "/between",
                           "did you mean");
}

TEST_CASE("no two constraints say the same") {
  const auto refused_twice = [](const json& document, const std::string& constraint, const std::string& again,
                                const std::string& word) {
    check_constraint_refused(and_also(document, constraint), again, "", word);
  };
  const std::string angle = R"(, "degrees": 10)";
  refused_twice(scene(), between("angle", R"("L")", R"("M")", angle),
                between("angle", R"("M")", R"("L")", angle),
                "'a1' and 'a2' both give the angle of 'M' and 'L'");
  refused_twice(scene(), between("parallel", R"(["p1", "p2"])", R"("E")"),
                between("parallel", R"("E")", R"(["p2", "p1"])"), "both say 'parallel' of 'E' and 'p2–p1'");
  refused_twice(scene(), R"({"type": "collinear", "between": ["p1", "p2", "p3"]})",
                R"({"type": "collinear", "between": ["p3", "p2", "p1"]})", "both say 'collinear'");
  refused_twice(scene(), R"({"id": "a2", "type": "on", "between": ["p1", "L"]})",
                between("distance", R"("p1")", R"("p2")", R"(, "length": 1)"), "'a2' is taken");
  // Of another type they say something else.
  CHECK(parsed(and_also(and_also(scene(), between("perpendicular", R"("L")", R"("M")")),
                        between("meet", R"("M")", R"("L")")))
            .problem.relations.size() == 2);
}

TEST_CASE("constraints that say nothing of the unknown are refused") {
  json document = with(scene(), "/fixed", {{"p1", {0, 0, 0}}, {"E", {{"normal", {0, 0, 1}}, {"offset", 1}}}});
  check_constraint_refused(document, between("on", R"("p1")", R"("E")"), "/between",
                           "'p1' and 'E' are both fixed; leave this constraint out");
  document["fixed"]["p2"] = {1, 0, 0};
  document["fixed"]["p3"] = {2, 0, 0};
  check_constraint_refused(document, R"({"type": "collinear", "between": ["p1", "p2", "p3"]})", "/between",
                           "'p1', 'p2' and 'p3' are all fixed");
  CHECK(parsed(and_also(document, R"({"type": "coplanar", "between": ["p1", "p2", "p3", "p4"]})"))
            .problem.relations.size() == 1);
  for (const std::string& constraint :
       {between("distance", R"("a1")", R"("a2")", R"(, "length": 3)"),
        between("perpendicular", R"(["a1", "a2"])", R"(["a1", "a3"])"),
        std::string(R"({"type": "collinear", "between": ["a1", "a2", "a3"]})")})
    check_constraint_refused(bodies(), constraint, "/between", "are elements of one body, 'base'");
  CHECK(relation_of(bodies(), R"({"type": "collinear", "between": ["a1", "a2", "q"]})").of.size() == 3);
}
