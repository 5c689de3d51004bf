#pragma once
/// JSON as it was written: every number keeps its decimal text, every object the order of its members.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/running/errors.hpp"

namespace gcs {

/// A JSON value. Exactly one of the members that match `kind` is meaningful.
struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;  ///< the nearest double
  std::string text;   ///< a number's decimal text as written, or a string's value
  std::vector<JsonValue> elements;
  std::vector<std::pair<std::string, JsonValue>> members{};

  /// Compiled once; inline the first would need pairs of this type before the type is complete.
  JsonValue();
  JsonValue(const JsonValue&);
  JsonValue(JsonValue&&) noexcept;
  JsonValue& operator=(const JsonValue&);
  JsonValue& operator=(JsonValue&&) noexcept;
  ~JsonValue();
  /// The member of that name, or nullptr. Precondition: an object.
  const JsonValue* find(std::string_view name) const;
};

/// Parses one JSON value. Refuses (InputError with the place): text that is not JSON, anything after the
/// value, duplicate keys, numbers that overflow a double or underflow to zero, nesting deeper than 64,
/// invalid UTF-8. `file` is only used in messages.
JsonValue parse_json(std::string_view text, const std::string& file);

/// `key` as one step of a JSON pointer (RFC 6901): "~" and "/" escaped.
std::string escaped_for_pointer(std::string_view key);

/// The value as JSON again, numbers with their own text. `indent` < 0: on one line.
std::string to_text(const JsonValue& value, int indent);

}  // namespace gcs
