#pragma once
/// Octahedra of points by the roots of their exact polynomial (exact_elimination.hpp), in balls of 512 bits: where
/// coordinates are so large beside the edges that doubles do not lead from diagonals to points.
///
/// At a simple root X the determinants are f₂Y² + f₁Y + f₀ and g₂Y² + g₁Y + g₀ with the common zero
/// Y = (f₂g₀ − g₂f₀)/(g₂f₁ − f₂g₁). The points are placed as in octahedron_placer.hpp, on the sides that leave all twelve
/// distances as they are given.

#include <vector>

#include "solvers/model/complex_points.hpp"
#include "solvers/octahedron/octahedron.hpp"

namespace gcs {

/// One figure for each root that leads to one, in the scene's frame, rounded to doubles, up to a mirror image. Left out are
/// roots that several solutions share. Nothing is proven of them.
std::vector<ComplexPoints> exactly_placed(const Scene& scene, const Octahedron& octahedron);

}  // namespace gcs
