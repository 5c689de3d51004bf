#include "solvers/reading/json_build.hpp"

#include <cmath>

namespace gcs {

namespace {

JsonValue of_kind(JsonValue::Kind kind) {
  JsonValue value;
  value.kind = kind;
  return value;
}

}  // namespace

JsonValue json_null() { return of_kind(JsonValue::Kind::null); }

JsonValue json_boolean(bool value) {
  JsonValue result = of_kind(JsonValue::Kind::boolean);
  result.boolean = value;
  return result;
}

JsonValue json_text(std::string text) {
  JsonValue result = of_kind(JsonValue::Kind::string);
  result.text = std::move(text);
  return result;
}

JsonValue json_array(std::vector<JsonValue> elements) {
  JsonValue result = of_kind(JsonValue::Kind::array);
  result.elements = std::move(elements);
  return result;
}

JsonValue json_object(JsonMembers members) {
  JsonValue result = of_kind(JsonValue::Kind::object);
  result.members = std::move(members);
  return result;
}

JsonValue json_number(double value) {
  if (!std::isfinite(value)) return json_null();
  JsonValue result = of_kind(JsonValue::Kind::number);
  result.number = value + 0.0;
  return result;
}

JsonValue json_complex(const std::complex<double>& value) {
  std::vector<JsonValue> parts(2);
  parts[0] = json_number(value.real());
  parts[1] = json_number(value.imag());
  return json_array(std::move(parts));
}

JsonValue json_count(const Natural& count) {
  const std::string text = count.decimal();
  if (count > Natural::power_of_two(53)) return json_text(text);
  JsonValue result = of_kind(JsonValue::Kind::number);
  result.number = count.approximate();
  result.text = text;
  return result;
}

JsonValue json_texts(const std::vector<std::string>& texts) { return json_array_of(texts, json_text); }

}  // namespace gcs
