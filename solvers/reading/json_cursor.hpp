#pragma once
/// Reading a JSON document field by field, every complaint with its place.

#include <Eigen/Core>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/reading/json_document.hpp"

namespace gcs {

/// A value inside a document and where it stands. Refers to the document and the file's name, which must
/// outlive it. Every function that reads throws InputError when the value is not what it asks for.
class JsonCursor {
 public:
  JsonCursor(const JsonValue& value, const std::string& file, std::string pointer = {})
      : value_(&value), file_(&file), pointer_(std::move(pointer)) {}

  const JsonValue& value() const { return *value_; }
  const std::string& pointer() const { return pointer_; }

  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;
  /// `what` about the name that this value holds, with the closest of `valid` as the remedy.
  [[noreturn]] void fail_unknown(const std::string& what, std::string_view name,
                                 const std::vector<std::string>& valid) const;

  bool is_null() const { return value_->kind == JsonValue::Kind::null; }
  bool is_object() const { return value_->kind == JsonValue::Kind::object; }
  bool is_array() const { return value_->kind == JsonValue::Kind::array; }
  /// The value is an object without any other members than these.
  void allow_members(std::initializer_list<std::string_view> names) const;
  bool has(std::string_view name) const { return value_->find(name) != nullptr; }
  JsonCursor required(std::string_view name) const;
  /// The object's member "format" is this one.
  void require_format(std::string_view name) const;
  std::optional<JsonCursor> optional(std::string_view name) const;
  std::vector<std::pair<std::string, JsonCursor>> members() const;
  std::vector<JsonCursor> elements() const;
  /// The elements of an array of exactly `count`; `of_what` completes "needs exactly … ".
  std::vector<JsonCursor> elements(std::size_t count, const std::string& of_what) const;

  bool boolean() const;
  std::string text() const;
  /// A text with at least one character and no control character.
  std::string name() const;
  /// The key of this value is such a text, too.
  void require_name(const std::string& key) const;
  Decimal number() const;
  double number_value() const;
  /// `dimension` coordinates; in the plane z = 0.
  Eigen::Vector3d coordinates(int dimension) const;
  /// The numbers themselves.
  std::vector<Decimal> decimals(int dimension) const;
  /// Their decimal texts; the third is empty in the plane.
  std::array<std::string, 3> coordinate_texts(int dimension) const;
  /// {"point": […], "direction": […]}, the direction brought to length 1.
  LinePosition line_position(int dimension) const;
  /// {"normal": […], "offset": h} in space, the normal brought to length 1 and the offset divided likewise.
  PlanePosition plane_position() const;

 private:
  void expect(JsonValue::Kind kind) const;
  JsonCursor member(std::string_view name, const JsonValue& value) const;

  const JsonValue* value_;
  const std::string* file_;
  std::string pointer_;
};

}  // namespace gcs
