#pragma once
/// Where an element of any kind is, and what that says of others.

#include <variant>
#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Of a point, a line or a plane.
using ElementPosition = std::variant<Eigen::Vector3d, LinePosition, PlanePosition>;

/// How many independent rigid motions of the plane or of space leave all elements where they are.
int motions_left(const std::vector<ElementPosition>& elements, int dimension);

/// What no motion changes of two elements.
struct Measure {
  bool is_distance = true;  ///< or a cosine
  double value = 0;         ///< from a plane's side with a sign
};

/// Of the same kinds of elements the same measures, but that parallel ones may have one more.
std::vector<Measure> measures(const ElementPosition& a, const ElementPosition& b);

}  // namespace gcs
