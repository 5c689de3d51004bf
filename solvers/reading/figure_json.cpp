#include "solvers/reading/figure_json.hpp"

#include "solvers/model/complex_lines.hpp"

namespace gcs {
namespace {

JsonValue vector_value(const Eigen::Vector3cd& vector, int dimension, bool is_real) {
  return is_real ? json_coordinates(vector.real(), dimension)
                 : json_array_of(vector.head(dimension), json_complex);
}

double read_part(const JsonCursor& part) { return part.number_value(); }

Eigen::Vector3cd read_vector(const JsonCursor& cursor, int dimension, bool is_real) {
  return Eigen::Vector3cd(
      read_coordinates<std::complex<double>>(cursor, dimension, is_real, read_part).data());
}

struct ComplexPlane {
  Eigen::Vector3cd normal;
  std::complex<double> offset;
};

/// The planes of a figure, real or not.
std::vector<ComplexPlane> complex_planes(const Figure& figure) {
  std::vector<ComplexPlane> planes;
  for (const PlanePosition& plane : figure.planes)
    planes.push_back({plane.normal.cast<std::complex<double>>(), plane.offset});
  for (std::size_t i = 0; i < figure.imaginary_planes.size(); ++i) {
    planes[i].normal.imag() = figure.imaginary_planes[i].normal;
    planes[i].offset.imag(figure.imaginary_planes[i].offset);
  }
  return planes;
}

ComplexPlane read_plane(const JsonCursor& plane, bool is_real) {
  const JsonCursor offset = plane.required("offset");
  return {read_vector(plane.required("normal"), 3, is_real),
          is_real ? read_part(offset) : read_complex(offset)};
}

void add_plane(const ComplexPlane& plane, bool is_real, Figure& figure) {
  figure.planes.push_back({plane.normal.real(), plane.offset.real()});
  if (!is_real) figure.imaginary_planes.push_back({plane.normal.imag(), plane.offset.imag()});
}

}  // namespace

JsonValue json_coordinates(const Eigen::Vector3d& vector, int dimension) {
  return json_array_of(vector.head(dimension), json_number);
}

JsonValue json_line(JsonValue point, JsonValue direction) {
  return json_object({{"point", std::move(point)}, {"direction", std::move(direction)}});
}

JsonValue json_line_position(const LinePosition& line, int dimension) {
  return json_line(json_coordinates(line.point, dimension), json_coordinates(line.direction, dimension));
}

JsonValue json_plane(JsonValue normal, JsonValue offset) {
  return json_object({{"normal", std::move(normal)}, {"offset", std::move(offset)}});
}

JsonValue json_plane_position(const PlanePosition& plane) {
  return json_plane(json_coordinates(plane.normal, 3), json_number(plane.offset));
}

JsonValue json_points(const ProblemStatement& names, const Figure& figure) {
  const ComplexPoints points = complex_points(figure);
  return json_object_of(names.points, points.colwise(), [&](const Eigen::Vector3cd& point) {
    return vector_value(point, names.dimension, figure.is_real());
  });
}

JsonValue json_lines(const ProblemStatement& names, const Figure& figure) {
  return json_object_of(names.lines, complex_lines(figure), [&](const ComplexLine& line) {
    return json_line(vector_value(line.point, names.dimension, figure.is_real()),
                     vector_value(line.direction, names.dimension, figure.is_real()));
  });
}

JsonValue json_planes(const ProblemStatement& names, const Figure& figure) {
  return json_object_of(names.planes, complex_planes(figure), [&](const ComplexPlane& plane) {
    return json_plane(vector_value(plane.normal, 3, figure.is_real()),
                      figure.is_real() ? json_number(plane.offset.real()) : json_complex(plane.offset));
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
    lines.push_back({read_vector(line.required("point"), names.dimension, is_real),
                     read_vector(line.required("direction"), names.dimension, is_real)});
  }
  Figure result = figure_of(points, lines, is_real);
  for (const std::string& name : names.planes)
    add_plane(read_plane(figure.required("planes").required(name), is_real), is_real, result);
  return result;
}

}  // namespace gcs
