#pragma once
/// What homotopies from x_i^(d_i) = 1 have in common, however their equations are written.

#include <random>
#include <vector>

#include "solvers/lanes/elimination.hpp"
#include "solvers/lanes/monomial_system.hpp"

namespace gcs {

/// All x with x_i^(d_i) = 1. Precondition: d_i ≥ 1.
std::vector<ComplexVectorX> roots_of_unity(const std::vector<int>& degrees);

/// An order for the way from the coefficients `from` to `to`, from these starts: by Jacobians at some of them, and in the
/// middle of the way at random points. Precondition: there is a start.
Elimination order_elimination(const MonomialSystem& system, const std::vector<ComplexVectorX>& starts,
                              const ComplexVectorX& from, const ComplexVectorX& to, std::mt19937_64& random);

}  // namespace gcs
