#include "solvers/solving/problem.hpp"

#include <fmt/format.h>

#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

/// A decimal fraction has no more digits than this that equals a double.
constexpr int most_significant_digits = 767;

/// What is no number stays a text, which the check of the instance refuses with its place.
JsonValue number_value(const GivenNumber& number) {
  try {
    const JsonValue value = parse_json(number.text(), "problem");
    if (value.kind == JsonValue::Kind::number) return value;
  } catch (const InputError&) {
  }
  return json_text(number.text());
}

JsonValue numbers_value(std::initializer_list<GivenNumber> numbers) {
  return json_array_of(numbers, number_value);
}

JsonValue distance_value(const std::string& a, const std::string& b, const std::string& kind,
                         const GivenNumber& number) {
  return json_object(
      {{"type", json_text("distance")}, {"between", json_texts({a, b})}, {kind, number_value(number)}});
}

}  // namespace

GivenNumber::GivenNumber(double value) : text_(fmt::format("{:.{}g}", value, most_significant_digits)) {}

Problem& Problem::distance(const std::string& a, const std::string& b, const GivenNumber& length) {
  constraints_.push_back(distance_value(a, b, "length", length));
  return *this;
}

Problem& Problem::squared_distance(const std::string& a, const std::string& b, const GivenNumber& square) {
  constraints_.push_back(distance_value(a, b, "squared", square));
  return *this;
}

Problem& Problem::fix(const std::string& point, std::initializer_list<GivenNumber> coordinates) {
  fixed_.emplace_back(point, numbers_value(coordinates));
  return *this;
}

Problem& Problem::fix(const std::string& line, std::initializer_list<GivenNumber> point,
                      std::initializer_list<GivenNumber> direction) {
  fixed_.emplace_back(line, json_line(numbers_value(point), numbers_value(direction)));
  return *this;
}

Problem& Problem::sketch(const std::string& point, std::initializer_list<GivenNumber> coordinates) {
  sketch_.emplace_back(point, numbers_value(coordinates));
  return *this;
}

Problem& Problem::sketch(const std::string& line, std::initializer_list<GivenNumber> point,
                         std::initializer_list<GivenNumber> direction) {
  sketch_.emplace_back(line, json_line(numbers_value(point), numbers_value(direction)));
  return *this;
}

Instance Problem::instance() const {
  JsonMembers members{{"format", json_text("gcsbench-instance/1")},
                      {"id", json_text("problem")},
                      {"dimension", json_number(dimension_)},
                      {"points", json_texts(points_)},
                      {"constraints", json_array(constraints_)}};
  if (!lines_.empty()) members.emplace_back("lines", json_texts(lines_));
  if (!fixed_.empty()) members.emplace_back("fixed", json_object(fixed_));
  if (!sketch_.empty()) members.emplace_back("sketch", json_object(sketch_));
  return parse_instance(to_text(json_object(std::move(members)), -1), "problem");
}

}  // namespace gcs
