#include "harness/results/decimal_json.hpp"

#include <span>

#include "solvers/reading/figure_json.hpp"

namespace gcs {

JsonValue json_decimal(const DecimalNumber& number, bool is_real) {
  return is_real ? json_text(number.re) : json_texts({number.re, number.im});
}

JsonValue json_decimals(const DecimalVector& vector, int dimension, bool is_real) {
  const auto number_value = [&](const DecimalNumber& number) { return json_decimal(number, is_real); };
  return json_array_of(std::span(vector).first(static_cast<std::size_t>(dimension)), number_value);
}

JsonMembers decimal_members(const ProblemStatement& problem, const DecimalFigure& figure, bool is_real) {
  const auto point_value = [&](const DecimalVector& point) {
    return json_decimals(point, problem.dimension, is_real);
  };
  const auto line_value = [&](const DecimalFigure::Line& line) {
    return json_line(json_decimals(line.point, problem.dimension, is_real),
                     json_decimals(line.direction, problem.dimension, is_real));
  };
  const auto plane_value = [&](const DecimalFigure::Plane& plane) {
    return json_plane(json_decimals(plane.normal, 3, is_real), json_decimal(plane.offset, is_real));
  };
  JsonMembers members{{"points", json_object_of(problem.points, figure.points, point_value)},
                      {"lines", json_object_of(problem.lines, figure.lines, line_value)}};
  if (!problem.planes.empty())
    members.emplace_back("planes", json_object_of(problem.planes, figure.planes, plane_value));
  members.emplace_back("error_bound", json_number(figure.error));
  members.emplace_back("unique_within", json_number(figure.unique));
  members.emplace_back("bits", json_number(figure.bits));
  return members;
}

}  // namespace gcs
