#pragma once
/// Octahedra: six points with all distances but three disjoint ones, or six points and planes with all pairs but three
/// disjoint ones, each of a point and another element.

#include <array>
#include <optional>

#include "solvers/octahedron/pair_entries.hpp"
#include "solvers/structure/core_reduction.hpp"

namespace gcs {

/// The six elements in three opposite pairs: (a, a'), (b, b'), (c, c').
struct Octahedron {
  std::array<std::array<int, 2>, 3> pair;
};

/// The core of the scene as an octahedron, if it is one.
std::optional<Octahedron> find_octahedron(const Scene& scene, const CoreReduction& reduction);
/// A whole general scene as one, the point of each pair first, if it is nothing else.
std::optional<Octahedron> find_octahedron_with_planes(const Scene& scene);

/// Of the triangle abc: 16 area² over the fourth power of the longest side; at most 3, and 0 where it is
/// flat; −1 where they are not all points.
double roundness_of_base(const PairEntries& entries, const Octahedron& octahedron);

/// Elements swapped within pairs so that the triangle abc, on which all else is placed, is as round as can be.
Octahedron with_round_base(const Octahedron& octahedron, const PairEntries& entries);

}  // namespace gcs
