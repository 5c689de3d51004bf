#pragma once
/// The solutions of an octahedron by its squared diagonals, in coordinates.

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "solvers/model/complex_points.hpp"
#include "solvers/octahedron/diagonal_zeros.hpp"
#include "solvers/running/work.hpp"
#include "solvers/structure/core_reduction.hpp"

namespace gcs {

/// Below this reciprocal condition a solution is nearly singular: another one may be about so near, relative
/// to the figure, and Newton's method in doubles may have gone to either, or stopped between them.
inline constexpr double nearly_singular = 1e-6;

/// A solution of the core: all its distances follow from the three diagonals.
struct CoreSolution {
  ComplexPoints points;
  std::array<std::complex<double>, 3> diagonals;
  WidePoints wide;  ///< the same points where rounding them to doubles loses some distances; or empty
  bool is_singular = false;
  int multiplicity = 1;  ///< of all those together that were taken for this one

  double tolerance() const { return is_singular ? 1e-5 : 1e-9; }  ///< relative to the figure's squared size
};

/// What the eight eigenvalues came to.
struct CoreSolutions {
  /// Common zeros of two polynomials of bidegree (2, 2): Bézout on P¹ × P¹.
  static constexpr int pairs = 8;

  int total_degree = 0;  ///< of the two equations
  std::vector<CoreSolution> list;
  std::array<int, 3> frame{};  ///< points at the origin, on the x-axis and in the xy-plane
  int at_infinity = 0;
  int far_away = 0;                             ///< eigenvalues that led to no solution but far away
  bool common_factor = false;                   ///< to rounding
  bool flexible = false;                        ///< proven
  std::optional<EliminationFacts> elimination;  ///< where they were found so

  int accounted_for() const;
  /// Nothing that a curve of solutions may have left behind.
  bool are_all_isolated() const;
};

/// Of the scene's core, which is an octahedron, with each choice of two diagonals until nothing is missing:
/// of a, a', b, b' that are coplanar, or nearly, at solutions the diagonals say little of where c and c' are.
/// Where eigenvalues, whose errors grow with the condition of their matrix, do not lead to all, the roots of the exact
/// polynomial are taken if they lead to more. Adds to `work`.
CoreSolutions solve_core(const Scene& scene, const CoreReduction& reduction, DiagonalMethod method,
                         WorkCounters& work);

}  // namespace gcs
