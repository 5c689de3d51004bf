#include "harness/tests/instances/general_samples.hpp"

#include "harness/tests/instances/instance_samples.hpp"

namespace gcs::samples {

using nlohmann::json;

json scene() {
  return json::parse(R"({
    "format": "gcsbench-instance/2", "id": "small", "dimension": 3,
    "points": ["p1", "p2", "p3", "p4"], "lines": ["L", "M"], "planes": ["E", "F"],
    "constraints": []})");
}

json plane_scene() { return with(with(scene(), "/planes", nullptr), "/dimension", 2); }

json bodies() {
  return json::parse(R"({
    "format": "gcsbench-instance/2", "id": "small", "dimension": 3, "points": ["q"],
    "bodies": {"base": {"a1": [0, 0, 0], "a2": [3, 0, 0], "a3": [0, 4, 0]},
               "top": {"b1": [1, 0, 0], "b2": [2, 0, 0], "b3": [1, 1.5, 0]}},
    "constraints": [{"type": "distance", "between": ["a1", "b1"], "length": 2}]})");
}

json and_also(json document, const std::string& constraint) {
  document["constraints"].push_back(json::parse(constraint));
  return document;
}

Relation relation_of(const json& document, const std::string& constraint) {
  return parsed(and_also(document, constraint)).problem.relations.back();
}

void check_constraint_refused(const json& document, const std::string& constraint, const std::string& pointer,
                              const std::string& word) {
  const std::string place = "/constraints/" + std::to_string(document["constraints"].size());
  check_refused(and_also(document, constraint), place + pointer, word);
}

std::string between(const std::string& type, const std::string& a, const std::string& b,
                    const std::string& value) {
  return R"({"type": ")" + type + R"(", "between": [)" + a + ", " + b + "]" + value + "}";
}

}  // namespace gcs::samples
