#pragma once
/// Real roots of a polynomial in an interval, by sign variations of its Bernstein coefficients (Lane,
/// Riesenfeld 1981).

#include <span>
#include <vector>

namespace gcs {

/// All real roots of Σ c[i]·s^i with 0 < s ≤ `end`, ascending; a root counts once whatever its multiplicity,
/// and two roots closer than 1e-12·end may count as one. Precondition: end > 0, c not empty, at most 64
/// coefficients.
std::vector<double> real_roots(std::span<const double> c, double end);

}  // namespace gcs
