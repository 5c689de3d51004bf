#include "solvers/reading/figure_json.hpp"

#include "solvers/model/complex_lines.hpp"

namespace gcs {
namespace {

JsonValue vector_value(const Eigen::Vector3cd& vector, int dimension, bool is_real) {
  return is_real ? json_coordinates(vector.real(), dimension)
                 : json_array_of(vector.head(dimension), json_complex);
}

double read_part(const JsonCursor& part) { return part.number().value; }

Eigen::Vector3cd read_vector(const JsonCursor& cursor, int dimension, bool is_real) {
  return Eigen::Vector3cd(
      read_coordinates<std::complex<double>>(cursor, dimension, is_real, read_part).data());
}

}  // namespace

JsonValue json_coordinates(const Eigen::Vector3d& vector, int dimension) {
  return json_array_of(vector.head(dimension), json_number);
}

JsonValue json_line(JsonValue point, JsonValue direction) {
  return json_object({{"point", std::move(point)}, {"direction", std::move(direction)}});
}

JsonValue json_line_position(const LinePosition& line) {
  return json_line(json_coordinates(line.point, 3), json_coordinates(line.direction, 3));
}

JsonValue json_points(const ProblemStatement& names, const Figure& figure) {
  const ComplexPoints points = complex_points(figure);
  return json_object_of(names.points, points.colwise(), [&](const Eigen::Vector3cd& point) {
    return vector_value(point, names.dimension, figure.is_real());
  });
}

JsonValue json_lines(const ProblemStatement& names, const Figure& figure) {
  return json_object_of(names.lines, complex_lines(figure), [&](const ComplexLine& line) {
    return json_line(vector_value(line.point, 3, figure.is_real()),
                     vector_value(line.direction, 3, figure.is_real()));
  });
}

std::complex<double> read_complex(const JsonCursor& cursor) {
  return read_complex<std::complex<double>>(cursor, read_part);
}

ComplexPoints read_points(const JsonCursor& points, const ProblemStatement& names, bool is_real) {
  ComplexPoints result(3, static_cast<Eigen::Index>(names.points.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) =
        read_vector(points.required(names.points[static_cast<std::size_t>(i)]), names.dimension, is_real);
  return result;
}

Figure read_figure(const JsonCursor& figure, const ProblemStatement& names, bool is_real) {
  const ComplexPoints points = read_points(figure.required("points"), names, is_real);
  std::vector<ComplexLine> lines;
  for (const std::string& name : names.lines) {
    const JsonCursor line = figure.required("lines").required(name);
    lines.push_back({read_vector(line.required("point"), 3, is_real),
                     read_vector(line.required("direction"), 3, is_real)});
  }
  return figure_of(points, lines, is_real);
}

}  // namespace gcs
