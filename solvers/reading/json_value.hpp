#pragma once
/// JSON as it was written: every number keeps its decimal text, every object the order of its members.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gcs {

/// A JSON value. Exactly one of the members that match `kind` is meaningful.
struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;  ///< the nearest double
  std::string text;   ///< a number's decimal text, empty for the shortest of the double; or a string's value
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

/// `key` as one step of a JSON pointer (RFC 6901): "~" and "/" escaped.
std::string escaped_for_pointer(std::string_view key);

/// The decimal text of a number.
std::string number_text(const JsonValue& number);

/// The value as JSON again, numbers with their own text. `indent` < 0: on one line.
std::string to_text(const JsonValue& value, int indent);

}  // namespace gcs
