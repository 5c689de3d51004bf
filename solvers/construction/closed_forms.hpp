#pragma once
/// Instructions that know all places of an element: which of what is given they use.

#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// What instructions see in a constraint between two elements.
enum class MetBy {
  distance,       ///< of a point from a point, a line or a plane, from its side; 0 on a line or a plane
  product,        ///< of unit directions and normals, of a line its size alone: the cosine of two planes
  one_direction,  ///< two lines or planes are parallel, or a line is perpendicular to a plane
  anything        ///< else
};

/// One end of a constraint as seen from the other, in the scene's unit.
struct GivenFrom {
  int other = -1;
  MetBy met_by = MetBy::anything;
  double value = 0;
  int conditions = 1;   ///< how many coordinates it takes
  int constraint = -1;  ///< its number, as of values
};

/// Points come first in what is given, then planes, then lines.
int rank_of(const ProblemStatement& problem, int element);

/// Whether a point lies on a line in space: two conditions.
bool is_on_line(const ProblemStatement& problem, int element, const GivenFrom& from);

/// Of what is given of an element what the closed form of its places uses, in the same order; nothing where there is none.
/// - A point: on a sphere, and further spheres and planes, the frame's `zeros` among them, or one cylinder; on a line, and
///   a further sphere, plane or cylinder; on three planes, two planes and a cylinder, a plane and a cylinder, two
///   cylinders. In the plane lines are planes, on either side of theirs.
/// - A plane: at a distance from a point; distances from further points, products with planes and lines, or along a line.
/// - A line in the plane: at a distance from a point; distances from points, products with lines.
/// - A line in space: through a point; through or at a distance from further points, products with lines and planes, or in
///   a given direction. Or in a given direction, at distances from points.
std::vector<GivenFrom> used_in_closed_form(const ProblemStatement& problem, int element, int zeros,
                                           const std::vector<GivenFrom>& given);

}  // namespace gcs
