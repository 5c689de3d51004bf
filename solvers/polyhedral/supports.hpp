#pragma once
/// Square systems of sparse polynomials, and two formulations of the distance equations as such.

#include <vector>

#include "solvers/lanes/square_system.hpp"

namespace gcs {

/// One exponent per unknown; negative ones are allowed.
using Exponents = std::vector<int>;
/// The monomials of one equation: all different, at least one.
using Support = std::vector<Exponents>;
/// One support per equation, and as many equations as unknowns.
using Supports = std::vector<Support>;

/// Polynomials in C^n.
struct SparseEquations {
  Supports supports;
  std::vector<ComplexVectorX> coefficients;  ///< of each equation, in the order of its support
  /// Which unknown is the i-th unknown coordinate of the frame; −1 for those that are known here.
  std::vector<int> unknown_of;
};

/// Σ (u − v)² − A multiplied out, for the A that x has, in the unknown coordinates of the frame: those that
/// the reference has are unknowns as any other. Order per equation: for every difference u², then v² and uv
/// or, where v is a constant and not 0, u; 1 at the end. Precondition: no linear terms.
SparseEquations coordinate_equations(const SquareSystem& system, const ComplexVectorX& x);

/// With a further unknown s_j = p_j·p_j for every point that is not known: s_j − p_j·p_j for every such
/// point, then s_j + s_k − 2 p_j·p_k − A for every edge, with p_j·p_k multiplied out, and s_j − x_j² − A for
/// the distance from a line; for the A that the placement x has. A known p_k leaves s_j, the coordinates of
/// p_j for which its own are not 0, and 1. Known, as x has them, are points that the file fixes and, if all
/// distances within the reference are given, the points of the reference; the edges among known points are
/// left out. Unknowns are numbered point by point, the coordinates that the frame leaves unknown before s_j.
/// Order per equation: s_j, s_k, products of coordinates axis by axis, 1.
SparseEquations sphere_equations(const DistanceSystem& system, const ComplexVectorX& x);

}  // namespace gcs
