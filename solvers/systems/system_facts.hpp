#pragma once
/// What a system costs, counted from its polynomials.

#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/systems/polynomial_system.hpp"

namespace gcs {

/// unknowns, terms, total_degree, homogeneous_bound (small_homogeneous_bound) and, where its mixed cells are enumerated,
/// mixed_volume. Precondition: no equation is 0.
std::vector<Particular> system_facts(const PolynomialSystem& system, const SolveMeans& means);

}  // namespace gcs
