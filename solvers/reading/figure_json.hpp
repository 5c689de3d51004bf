#pragma once
/// Positions in files: a point as [x, y, z], in the plane [x, y]; a line as {"point": …, "direction": …}; a plane as
/// {"normal": …, "offset": …}; the points, lines and planes of a figure as objects by their names. A coordinate is a
/// number or, where a figure is complex, [re, im].

#include <Eigen/Core>
#include <array>

#include "solvers/model/complex_points.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// The first `dimension` coordinates.
JsonValue json_coordinates(const Eigen::Vector3d& vector, int dimension);
JsonValue json_line(JsonValue point, JsonValue direction);
JsonValue json_line_position(const LinePosition& line, int dimension);
JsonValue json_plane(JsonValue normal, JsonValue offset);
JsonValue json_plane_position(const PlanePosition& plane);

/// The points, lines or planes of a figure, real or not, by name. Precondition: the figure is one of `names`.
JsonValue json_points(const ProblemStatement& names, const Figure& figure);
JsonValue json_lines(const ProblemStatement& names, const Figure& figure);
JsonValue json_planes(const ProblemStatement& names, const Figure& figure);

/// A complex number of two numbers. Throws InputError where it is none.
std::complex<double> read_complex(const JsonCursor& cursor);

/// The points by name; whatever else the object has is left alone. Throws InputError where one is missing or is
/// no vector of numbers, of pairs [re, im] unless `is_real`.
ComplexPoints read_points(const JsonCursor& points, const ProblemStatement& names, bool is_real);

/// The members "points", "lines" and "planes"; the last two may be missing where there are none. A direction may have
/// any length, and a normal is taken as it is. Throws InputError as read_points does.
Figure read_figure(const JsonCursor& figure, const ProblemStatement& names, bool is_real);

/// [re, im], each part by `read_part(cursor)`. Throws InputError where there are not two, or as that does.
template <typename Number, typename ReadPart>
Number read_complex(const JsonCursor& cursor, ReadPart read_part) {
  if (cursor.value().elements.size() != 2) cursor.fail("this is no complex number", "give [re, im]");
  const std::vector<JsonCursor> parts = cursor.elements();
  return {read_part(parts[0]), read_part(parts[1])};
}

/// `dimension` coordinates, in the plane Number() for the third; each by `read_part(cursor)`, complex ones as by
/// read_complex. Throws InputError where there are more or fewer, or as those do.
template <typename Number, typename ReadPart>
std::array<Number, 3> read_coordinates(const JsonCursor& cursor, int dimension, bool is_real,
                                       ReadPart read_part) {
  const std::vector<JsonCursor> entries = cursor.elements(
      static_cast<std::size_t>(dimension), is_real ? "coordinates" : "complex coordinates [re, im]");
  std::array<Number, 3> result;
  for (std::size_t axis = 0; axis < entries.size(); ++axis)
    result[axis] =
        is_real ? Number{read_part(entries[axis])} : read_complex<Number>(entries[axis], read_part);
  return result;
}

}  // namespace gcs
