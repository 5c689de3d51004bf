#include "harness/tests/instances/instance_samples.hpp"

#include <catch2/catch.hpp>

namespace gcs::samples {

using nlohmann::json;

json plane() {
  return json::parse(R"({
    "format": "gcsbench-instance/1", "id": "small", "title": "Triangle", "dimension": 2,
    "points": ["p1", "p2", "p3"],
    "constraints": [
      {"id": "a1", "type": "distance", "between": ["p1", "p2"], "length": 3},
      {"id": "a2", "type": "distance", "between": ["p1", "p3"], "squared": 16.0},
      {"id": "a3", "type": "distance", "between": ["p2", "p3"], "length": 5}],
    "reference": {"origin": "p1", "axis": "p2"},
    "sketch": {"p1": [0, 0], "p2": [2, 0], "p3": [0, 3]},
    "interpolation": {"bent": "a2", "bend": 1.5},
    "construction": [
      {"place": "p1", "from": []}, {"place": "p2", "from": [["p1", "a1"]]},
      {"place": "p3", "from": [["p1", "a2"], ["p2", "a3"]]}],
    "published": [{"quantity": "real", "convention": "fixed frame", "value": 2, "source": "Euclid", "by": "compass"}],
    "notes": "right-angled"})");
}

json space() {
  json document = json::parse(R"({
    "format": "gcsbench-instance/1", "id": "small", "dimension": 3,
    "points": ["p1", "p2", "p3", "p4"], "lines": ["L"], "constraints": [],
    "sketch": {"p1": [0, 0, 0], "p2": [1, 0, 0], "p3": [0, 1, 0], "p4": [0, 0, 1],
               "L": {"point": [5, 0, 0.5], "direction": [0, 2, 0]}}})");
  const json& points = document["points"];
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      document["constraints"].push_back(
          {{"type", "distance"}, {"between", {points[a], points[b]}}, {"length", 1}});
    }
  }
  for (const json& point : points) {
    document["constraints"].push_back({{"type", "distance"}, {"between", {"L", point}}, {"length", 0.5}});
  }
  return document;
}

json bipyramid() {
  json document = space();
  document.erase("lines");
  document["points"].push_back("p5");
  document["sketch"].erase("L");
  document["sketch"]["p5"] = {1, 1, 1};
  for (std::size_t i = 0; i < 4; ++i) document["constraints"][6 + i]["between"][0] = "p5";
  document["constraints"].erase(9);
  return document;
}

json tangents() {
  json document = space();
  document.erase("sketch");
  document["constraints"].erase(document["constraints"].begin(), document["constraints"].begin() + 6);
  document["fixed"] = {{"p1", {1, 1, 1}}, {"p2", {1, -1, -1}}, {"p3", {-1, 1, -1}}, {"p4", {-1, -1, 1}}};
  return document;
}

Instance parsed(const json& document) { return gcs::parse_statement(document.dump(), "small.json", "small"); }

json with(json document, const std::string& pointer, const json& value) {
  const json::json_pointer place(pointer);
  if (value.is_null() && document[place.parent_pointer()].is_object()) {
    document[place.parent_pointer()].erase(place.back());
  } else if (value.is_null()) {
    document[place.parent_pointer()].erase(std::stoul(place.back()));
  } else {
    document[place] = value;
  }
  return document;
}

void check_refused(const json& document, const std::string& pointer, const std::string& word) {
  INFO(document.dump());
  try {
    parsed(document);
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.pointer() == pointer);
    CHECK_THAT(error.what(), Catch::StartsWith("small.json: ") && Catch::Contains(word));
  }
}

}  // namespace gcs::samples
