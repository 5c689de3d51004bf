#pragma once
/// Any sparse system as one whose monomials have two factors at most: trackers know no others.
///
/// A product of two unknowns that longer monomials need becomes an unknown, ℓ, with the equation ℓ − u·v = 0. Zeros are
/// the same but for the new coordinates; so is the mixed volume: with random coefficients ℓ = c·u·v turns the
/// equations back into ones with the supports that they had and random coefficients.

#include <array>
#include <vector>

#include "solvers/polyhedral/supports.hpp"

namespace gcs {

struct QuadraticLift {
  int unknowns = 0;                          ///< of the system that was given: they come first
  std::vector<std::array<int, 2>> products;  ///< unknown `unknowns` + k is the product of these two before it
  /// Those given, their monomials in the same order; then {ℓ, u·v} for each product.
  Supports supports;

  /// All coordinates of a point that has those given.
  ComplexVectorX lifted(ComplexVectorX x) const;
};

/// Precondition: no negative exponents; as many supports as unknowns.
QuadraticLift quadratic_lift(const Supports& supports);

}  // namespace gcs
