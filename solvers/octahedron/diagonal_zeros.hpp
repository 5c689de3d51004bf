#pragma once
/// The eight pairs of diagonals, by either method.

#include <optional>

#include "solvers/octahedron/diagonal_equations.hpp"

namespace gcs {

/// How the eight pairs of diagonals are found.
enum class DiagonalMethod {
  eigenvalues,  ///< of a matrix in doubles
  univariate    ///< as the roots of one polynomial, exact and isolated (exact_elimination.hpp)
};

/// What exact elimination says.
struct EliminationFacts {
  int degree = 0;  ///< of the polynomial in the height; −1: it is 0
  int distinct_real_roots = 0;
  std::optional<int> real_solutions;  ///< proven, in the fixed frame; nothing where that is not decided
};

struct DiagonalZeros {
  CommonZeros zeros;
  std::optional<EliminationFacts> elimination;  ///< where they were found so
};

/// `equations`: of that octahedron.
DiagonalZeros diagonal_zeros(const Scene& scene, const Octahedron& octahedron,
                             const DiagonalEquations& equations, DiagonalMethod method);

}  // namespace gcs
