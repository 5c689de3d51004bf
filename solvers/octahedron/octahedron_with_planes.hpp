#pragma once
/// Octahedral scenes with planes: points and planes by the diagonals that their Cayley–Menger determinants leave.

#include <vector>

#include "solvers/octahedron/diagonal_zeros.hpp"

namespace gcs {

struct PlacedOctahedra {
  int total_degree = 0;        ///< of the two equations
  bool common_factor = false;  ///< to rounding
  std::optional<EliminationFacts> elimination;
  std::vector<Figure>
      figures;  ///< complex, in the scene's frame, one of each two mirror images, as exact as doubles
                ///< leave them
};

/// By all pairs of diagonals aa', bb'. Precondition: find_octahedron_with_planes(scene.problem()) with its pairs in any order, and
/// some base of it is round.
PlacedOctahedra place_with_planes(const Scene& scene, const Octahedron& octahedron, DiagonalMethod method);

}  // namespace gcs
