#include "solvers/reading/json_cursor.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

std::string kind_name(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return "true or false";
    case JsonValue::Kind::number:
      return "a number";
    case JsonValue::Kind::string:
      return "a string";
    case JsonValue::Kind::array:
      return "an array";
    case JsonValue::Kind::object:
      return "an object";
  }
  return {};
}

}  // namespace

void JsonCursor::fail(const std::string& what, const std::string& remedy) const {
  throw InputError(*file_, pointer_, what, remedy);
}

void JsonCursor::fail_unknown(const std::string& what, std::string_view name,
                              const std::vector<std::string>& valid) const {
  const std::string nearest = nearest_name(name, valid);
  fail(what, nearest.empty() ? "there is none" : "did you mean '" + nearest + "'?");
}

void JsonCursor::allow_members(std::initializer_list<std::string_view> names) const {
  const std::vector<std::string> known(names.begin(), names.end());
  for (const auto& [name, cursor] : members()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError(
        *file_, cursor.pointer_, "unknown field '" + name + "'",
        "did you mean '" + nearest_name(name, known) + "'? The fields here are " + quoted_list(known));
  }
}

JsonCursor JsonCursor::required(std::string_view name) const {
  if (auto found = optional(name)) return *found;
  fail("the field '" + std::string(name) + "' is missing", "add it");
}

void JsonCursor::require_format(std::string_view name) const {
  const std::string remedy = "give a file of the format '" + std::string(name) + "'";
  if (!is_object() || !has("format")) fail("there is no field 'format'", remedy);
  const JsonCursor format = required("format");
  if (format.text() != name) format.fail("the format is '" + format.text() + "'", remedy);
}

std::optional<JsonCursor> JsonCursor::optional(std::string_view name) const {
  expect(JsonValue::Kind::object);
  const JsonValue* found = value_->find(name);
  return found == nullptr ? std::nullopt : std::optional(member(name, *found));
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
  expect(JsonValue::Kind::object);
  std::vector<std::pair<std::string, JsonCursor>> result;
  for (const auto& [name, value] : value_->members) result.emplace_back(name, member(name, value));
  return result;
}

std::vector<JsonCursor> JsonCursor::elements() const {
  expect(JsonValue::Kind::array);
  std::vector<JsonCursor> result;
  for (std::size_t i = 0; i < value_->elements.size(); ++i) {
    result.emplace_back(value_->elements[i], *file_, pointer_ + "/" + std::to_string(i));
  }
  return result;
}

std::vector<JsonCursor> JsonCursor::elements(std::size_t count, const std::string& of_what) const {
  std::vector<JsonCursor> result = elements();
  if (result.size() != count) {
    fail("there are " + std::to_string(result.size()) + " elements",
         "give exactly " + std::to_string(count) + " " + of_what);
  }
  return result;
}

bool JsonCursor::boolean() const {
  if (value_->kind != JsonValue::Kind::boolean) fail("this is neither true nor false", "give one of them");
  return value_->boolean;
}

std::string JsonCursor::text() const {
  expect(JsonValue::Kind::string);
  return value_->text;
}

std::string JsonCursor::name() const {
  const std::string result = text();
  require_name(result);
  return result;
}

void JsonCursor::require_name(const std::string& key) const {
  if (key.empty()) fail("the name is empty", "give at least one character");
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  if (std::any_of(key.begin(), key.end(), is_control))
    fail("the name has a control character", "leave it out: names are shown as they are");
}

Decimal JsonCursor::number() const {
  expect(JsonValue::Kind::number);
  return {value_->number, number_text(*value_)};
}

double JsonCursor::number_value() const {
  expect(JsonValue::Kind::number);
  return value_->number;
}

std::vector<Decimal> JsonCursor::decimals(int dimension) const {
  std::vector<Decimal> result;
  for (const JsonCursor& component : elements(static_cast<std::size_t>(dimension), "coordinates"))
    result.push_back(component.number());
  return result;
}

Eigen::Vector3d JsonCursor::coordinates(int dimension) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  int axis = 0;
  for (const JsonCursor& component : elements(static_cast<std::size_t>(dimension), "coordinates"))
    result[axis++] = component.number_value();
  return result;
}

std::array<std::string, 3> JsonCursor::coordinate_texts(int dimension) const {
  std::array<std::string, 3> texts;
  std::size_t axis = 0;
  for (const Decimal& component : decimals(dimension)) texts[axis++] = component.text;
  return texts;
}

LinePosition JsonCursor::line_position(int dimension) const {
  allow_members({"point", "direction"});
  const JsonCursor direction = required("direction");
  const LinePosition result{required("point").coordinates(dimension),
                            direction.coordinates(dimension).stableNormalized()};
  if (result.direction.isZero(0)) direction.fail("the direction is zero", "give a vector along the line");
  return result;
}

PlanePosition JsonCursor::plane_position() const {
  allow_members({"normal", "offset"});
  const JsonCursor normal = required("normal");
  const Eigen::Vector3d given = normal.coordinates(3);
  const double length = given.stableNorm();
  const PlanePosition result{given.stableNormalized(), required("offset").number().value / length};
  if (result.normal.isZero(0)) normal.fail("the normal is zero", "give a vector across the plane");
  if (!std::isfinite(result.offset))
    fail("the plane is too far away for a double", "give a longer normal or a smaller offset");
  return result;
}

void JsonCursor::expect(JsonValue::Kind kind) const {
  if (value_->kind == kind) return;
  fail("this is " + kind_name(value_->kind), kind_name(kind) + " is needed");
}

JsonCursor JsonCursor::member(std::string_view name, const JsonValue& value) const {
  return {value, *file_, pointer_ + "/" + escaped_for_pointer(name)};
}

}  // namespace gcs
