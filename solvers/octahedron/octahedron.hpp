#pragma once
/// Which face of an octahedron all else is placed on.

#include "solvers/octahedron/pair_entries.hpp"
#include "solvers/structure/octahedral_pairs.hpp"

namespace gcs {

/// Of the triangle abc: 16 area² over the fourth power of the longest side; at most 3, and 0 where it is
/// flat; −1 where they are not all points.
double roundness_of_base(const PairEntries& entries, const Octahedron& octahedron);

/// Elements swapped within pairs so that the triangle abc, on which all else is placed, is as round as can be.
Octahedron with_round_base(const Octahedron& octahedron, const PairEntries& entries);

}  // namespace gcs
