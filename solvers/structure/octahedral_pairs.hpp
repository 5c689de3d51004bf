#pragma once
/// Which elements of octahedra are opposite: of six points with all distances but three disjoint ones, or of six points and
/// planes with all pairs but three disjoint ones, each of a point and another element.

#include <array>
#include <optional>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/structure/core_reduction.hpp"

namespace gcs {

/// The six elements in three opposite pairs: (a, a'), (b, b'), (c, c').
struct Octahedron {
  std::array<std::array<int, 2>, 3> pair;
};

/// The core of points with distances as an octahedron, if it is one.
std::optional<Octahedron> find_octahedron(const ProblemStatement& problem, const CoreReduction& reduction);
/// A whole general problem as one, the point of each pair first, if it is nothing else.
std::optional<Octahedron> find_octahedron_with_planes(const ProblemStatement& problem);

/// The elements of a relation that states the distance of a point from a plane, 0 where it is on it, or the angle of two
/// planes, 90° where they are perpendicular. Nothing of any other relation.
std::optional<std::array<int, 2>> pair_with_plane(const ProblemStatement& problem, const Relation& relation);

}  // namespace gcs
