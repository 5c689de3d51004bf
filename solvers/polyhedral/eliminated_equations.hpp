#pragma once
/// Gaussian elimination of the monomials of equations, which leaves them the same zeros, and mostly fewer monomials and a
/// smaller mixed volume.

#include "solvers/lanes/monomial_system.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

struct EliminatedEquations {
  Supports supports;
  ComplexVectorX coefficients;  ///< one per monomial, equation by equation
};

/// The reduced echelon form for these coefficients, those of the highest degree eliminated first. A coefficient that is
/// rounding of what it was computed from is 0. Precondition: the equations are independent.
EliminatedEquations eliminated_equations(const MonomialSystem& system, const ComplexVectorX& coefficients);

}  // namespace gcs
