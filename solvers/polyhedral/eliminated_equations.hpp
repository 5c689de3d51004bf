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

/// The same equations with a constant term each, 0 where there was none: the mixed cells of these supports lead to the
/// zeros in C^n, where those without lead to zeros in (C*)^n alone (T. Y. Li, X. Wang, The BKK root count in C^n, Math.
/// Comp. 65, 1996).
EliminatedEquations with_constant_terms(EliminatedEquations equations);

}  // namespace gcs
