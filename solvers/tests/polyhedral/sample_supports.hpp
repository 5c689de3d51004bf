#pragma once
/// Supports of systems of the literature, of dense ones and of random ones.

#include <vector>

#include "solvers/polyhedral/supports.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs::samples {

/// Σ_i x_i ⋯ x_(i+k−1) = 0 for k = 1 … n − 1, and x_1 ⋯ x_n = 1.
Supports cyclic_roots(int n);
/// x_i Σ_(j≠i) x_j² − 1.1 x_i + 1 = 0.
Supports noon(int n);
/// Of n + 1 unknowns: Σ_l u_|l| u_|k−l| = u_k for k = 0 … n − 1, and Σ_l u_|l| = 1, l from −n to n.
Supports katsura(int n);
/// All monomials up to the given degree of each equation.
Supports dense(const std::vector<int>& degrees);
/// Different points with coordinates in [low, high].
Supports random_supports(int n, int points, int low, int high, RandomNumbers& random);

}  // namespace gcs::samples
