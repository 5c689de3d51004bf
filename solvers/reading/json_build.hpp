#pragma once
/// Makes JSON values. Numbers get the shortest text that reads back as the same double.

#include <complex>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/reading/json_value.hpp"

namespace gcs {

using JsonMembers = std::vector<std::pair<std::string, JsonValue>>;

JsonValue json_null();
JsonValue json_boolean(bool value);
JsonValue json_text(std::string text);
JsonValue json_array(std::vector<JsonValue> elements);
JsonValue json_object(JsonMembers members);

/// Null when not finite: JSON has no word for infinity. A negative zero becomes 0.
JsonValue json_number(double value);

/// [re, im], each as by json_number.
JsonValue json_complex(const std::complex<double>& value);

/// A decimal string above 2^53, which not every reader of JSON can hold as a number.
JsonValue json_count(const Natural& count);

/// An array of texts.
JsonValue json_texts(const std::vector<std::string>& texts);

/// The value that `make` makes of what the optional holds, or null.
template <typename T, typename Make>
JsonValue json_or_null(const std::optional<T>& value, Make make) {
  return value ? make(*value) : json_null();
}

/// The array of what `make` makes of each value.
template <typename Values, typename Make>
JsonValue json_array_of(const Values& values, Make make) {
  std::vector<JsonValue> elements;
  elements.reserve(static_cast<std::size_t>(std::distance(std::begin(values), std::end(values))));
  for (const auto& value : values) elements.push_back(make(value));
  return json_array(std::move(elements));
}

/// The object of what `make` makes of each value, by their names. Precondition: as many values as names.
template <typename Values, typename Make>
JsonValue json_object_of(const std::vector<std::string>& names, const Values& values, Make make) {
  JsonMembers members;
  members.reserve(names.size());
  auto value = values.begin();
  for (const std::string& name : names) members.emplace_back(name, make(*value++));
  return json_object(std::move(members));
}

}  // namespace gcs
