#include "solvers/solving/problem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solvers/elements/general_structure.hpp"
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

std::pair<std::string, JsonValue> member(const Placed& element) {
  return {element.name(), element.position()};
}

/// A name, or the two names of a segment.
JsonValue side_value(const Side& side) {
  return side.names().size() == 1 ? json_text(side.names().front()) : json_texts(side.names());
}

}  // namespace

GivenNumber::GivenNumber(double value) : text_(fmt::format("{:.{}g}", value, most_significant_digits)) {}

Placed::Placed(std::string name, std::initializer_list<GivenNumber> coordinates)
    : name_(std::move(name)), position_(numbers_value(coordinates)) {}

Placed::Placed(std::string name, std::initializer_list<GivenNumber> point,
               std::initializer_list<GivenNumber> direction)
    : name_(std::move(name)), position_(json_line(numbers_value(point), numbers_value(direction))) {}

Placed::Placed(std::string name, std::initializer_list<GivenNumber> normal, const GivenNumber& offset)
    : name_(std::move(name)), position_(json_plane(numbers_value(normal), number_value(offset))) {}

Problem& Problem::body(const std::string& name, std::initializer_list<Placed> elements) {
  JsonMembers members;
  for (const Placed& element : elements) members.push_back(member(element));
  bodies_.emplace_back(name, json_object(std::move(members)));
  return *this;
}

Problem& Problem::distance(const std::string& a, const std::string& b, const GivenNumber& length) {
  return distance_by(a, b, "length", length);
}

Problem& Problem::squared_distance(const std::string& a, const std::string& b, const GivenNumber& square) {
  return distance_by(a, b, "squared", square);
}

Problem& Problem::distance_by(const std::string& a, const std::string& b, const char* form,
                              const GivenNumber& number) {
  constraints_.push_back(json_object(
      {{"type", json_text("distance")}, {"between", json_texts({a, b})}, {form, number_value(number)}}));
  return *this;
}

Problem& Problem::angle(const Side& a, const Side& b, const GivenNumber& degrees) {
  return angle_by(a, b, "degrees", degrees);
}

Problem& Problem::angle_cosine(const Side& a, const Side& b, const GivenNumber& cosine) {
  return angle_by(a, b, "cosine", cosine);
}

Problem& Problem::angle_by(const Side& a, const Side& b, const char* form, const GivenNumber& number) {
  relate("angle", {side_value(a), side_value(b)});
  constraints_.back().members.emplace_back(form, number_value(number));
  return *this;
}

Problem& Problem::on(const std::string& a, const std::string& b) {
  return relate("on", {json_text(a), json_text(b)});
}

Problem& Problem::meet(const std::string& a, const std::string& b) {
  return relate("meet", {json_text(a), json_text(b)});
}

Problem& Problem::parallel(const Side& a, const Side& b) {
  return relate("parallel", {side_value(a), side_value(b)});
}

Problem& Problem::perpendicular(const Side& a, const Side& b) {
  return relate("perpendicular", {side_value(a), side_value(b)});
}

Problem& Problem::orientation(std::initializer_list<std::string> points, int sign) {
  constraints_.push_back(json_object(
      {{"type", json_text("orientation")}, {"of", json_texts(points)}, {"sign", json_number(sign)}}));
  return *this;
}

Problem& Problem::relate(const char* type, std::vector<JsonValue> between) {
  constraints_.push_back(
      json_object({{"type", json_text(type)}, {"between", json_array(std::move(between))}}));
  return *this;
}

Problem& Problem::fix(const std::string& point, std::initializer_list<GivenNumber> coordinates) {
  fixed_.push_back(member({point, coordinates}));
  return *this;
}

Problem& Problem::fix(const std::string& line, std::initializer_list<GivenNumber> point,
                      std::initializer_list<GivenNumber> direction) {
  fixed_.push_back(member({line, point, direction}));
  return *this;
}

Problem& Problem::fix(const std::string& plane, std::initializer_list<GivenNumber> normal,
                      const GivenNumber& offset) {
  fixed_.push_back(member({plane, normal, offset}));
  return *this;
}

Problem& Problem::sketch(const std::string& point, std::initializer_list<GivenNumber> coordinates) {
  sketch_.push_back(member({point, coordinates}));
  return *this;
}

Problem& Problem::sketch(const std::string& line, std::initializer_list<GivenNumber> point,
                         std::initializer_list<GivenNumber> direction) {
  sketch_.push_back(member({line, point, direction}));
  return *this;
}

Problem& Problem::sketch(const std::string& plane, std::initializer_list<GivenNumber> normal,
                         const GivenNumber& offset) {
  sketch_.push_back(member({plane, normal, offset}));
  return *this;
}

bool Problem::is_general() const {
  const auto is_line = [&](const JsonValue& name) {
    return std::count(lines_.begin(), lines_.end(), name.text) > 0;
  };
  const auto is_relation = [&](const JsonValue& constraint) {
    if (constraint.find("type")->text != "distance") return true;
    const std::vector<JsonValue>& ends = constraint.find("between")->elements;
    return std::all_of(ends.begin(), ends.end(), is_line);
  };
  const bool leaves_motions = !fixed_.empty() && fixed_.size() < static_cast<std::size_t>(dimension_);
  return leaves_motions || !planes_.empty() || !bodies_.empty() || (dimension_ == 2 && !lines_.empty()) ||
         std::any_of(constraints_.begin(), constraints_.end(), is_relation);
}

Instance Problem::instance() const {
  JsonMembers members{{"format", json_text(is_general() ? "gcsbench-instance/2" : "gcsbench-instance/1")},
                      {"id", json_text("problem")},
                      {"dimension", json_number(dimension_)},
                      {"points", json_texts(points_)},
                      {"constraints", json_array(constraints_)}};
  if (!lines_.empty()) members.emplace_back("lines", json_texts(lines_));
  if (!planes_.empty()) members.emplace_back("planes", json_texts(planes_));
  if (!bodies_.empty()) members.emplace_back("bodies", json_object(bodies_));
  if (!fixed_.empty()) members.emplace_back("fixed", json_object(fixed_));
  if (!sketch_.empty()) members.emplace_back("sketch", json_object(sketch_));
  return parse_statement(to_text(json_object(std::move(members)), -1), "problem");
}

Problem::operator Scene() const {
  const Instance stated = instance();
  if (stated.problem.is_general()) require_general_well_posed(stated.problem, "problem");
  return stated;
}

}  // namespace gcs
