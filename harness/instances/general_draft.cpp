#include "harness/instances/general_draft.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gcs {
namespace {

/// What is rounded off matters to no double, and to no ε of the families.
constexpr int decimal_places = 50;

std::string list_text(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(fmt::format("\"{}\"", name));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string operand_text(std::string_view operand) {
  return operand.starts_with('[') ? std::string(operand) : fmt::format("\"{}\"", operand);
}

}  // namespace

std::vector<std::string> names_of(const NamedPoints& points) {
  std::vector<std::string> names;
  for (const NamedPoint& point : points) names.push_back(point.name);
  return names;
}

const ExactPoint& place_of(const NamedPoints& points, std::string_view name) {
  return std::ranges::find(points, name, &NamedPoint::name)->at;
}

LongDecimal dot(const ExactPoint& a, const ExactPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactPoint difference(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::string coordinates_text(const ExactPoint& point, int dimension) {
  std::vector<std::string> numbers;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    numbers.push_back(point[axis].text(decimal_places));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string body_text(std::string_view name, const NamedPoints& points, int dimension) {
  std::vector<std::string> members;
  for (const NamedPoint& point : points)
    members.push_back(fmt::format("\"{}\": {}", point.name, coordinates_text(point.at, dimension)));
  return fmt::format("\"{}\": {{{}}}", name, fmt::join(members, ", "));
}

std::string relation_text(std::string_view type, std::string_view a, std::string_view b) {
  return fmt::format(R"({{"type": "{}", "between": [{}, {}]}})", type, operand_text(a), operand_text(b));
}

std::string relation_text(std::string_view type, std::string_view a, std::string_view b,
                          std::string_view member, const LongDecimal& value) {
  return fmt::format(R"({{"type": "{}", "between": [{}, {}], "{}": {}}})", type, operand_text(a),
                     operand_text(b), member, value.text(decimal_places));
}

std::string distance_text(const NamedPoints& points, std::string_view a, std::string_view b) {
  return relation_text("distance", a, b, "squared",
                       squared_distance(place_of(points, a), place_of(points, b)));
}

std::string text_of(const std::string& id, const GeneralDraft& draft) {
  std::string more;
  if (!draft.lines.empty()) more += ", \"lines\": " + list_text(draft.lines);
  if (!draft.planes.empty()) more += ", \"planes\": " + list_text(draft.planes);
  if (!draft.bodies.empty()) more += fmt::format(", \"bodies\": {{{}}}", fmt::join(draft.bodies, ", "));
  return fmt::format(
      R"({{"format": "gcsbench-instance/2", "id": "{}", "dimension": {}, "points": {}, "constraints": [{}]{}}})",
      id, draft.dimension, list_text(draft.points), fmt::join(draft.constraints, ", "), more);
}

}  // namespace gcs
