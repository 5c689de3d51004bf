#pragma once
/// Where bodies have their elements, and rigid motions of these.

#include <variant>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Of a point, a line or a plane.
using ElementPosition = std::variant<Eigen::Vector3d, LinePosition, PlanePosition>;

/// Where its body has the element, in doubles, in a unit of 2^−exponent of the file's; directions and normals of length 1.
ElementPosition position_in_body(const ProblemStatement& problem, const BodyElement& element,
                                 int exponent = 0);

/// Where a figure has an entity of the problem.
ElementPosition position_of(const ProblemStatement& problem, int entity, const Figure& figure);

/// Puts an entity of the problem there. Precondition: the figure has a place for it.
void put(const ProblemStatement& problem, int entity, const ElementPosition& position, Figure& figure);

/// How many independent rigid motions of the plane or of space leave all elements where they are,
/// to the rounding of doubles.
int motions_left(const std::vector<ElementPosition>& elements, int dimension);

/// x ↦ turn·x + shift, without a reflection.
struct BodyMotion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  ElementPosition operator()(const ElementPosition& position) const;
};

/// The motion that brings points, and normals of planes, nearest to others of the same kinds in the same order, by least
/// squares with coordinates relative to the largest (Kabsch 1976). Precondition: there is a point.
BodyMotion nearest_motion(const std::vector<ElementPosition>& from, const std::vector<ElementPosition>& to,
                          int dimension);

}  // namespace gcs
