#pragma once
/// Real polynomials in an interval. Their roots are found by sign variations of its Bernstein coefficients
/// (Lane, Riesenfeld 1981).

#include <span>
#include <vector>

namespace gcs {

/// All real roots of Σ c[i]·s^i with 0 < s ≤ `end`, ascending. Two roots closer than 4e-12·end count as one;
/// a multiple root may be found as several, or missed where rounding lifts it off the axis (1e-8·end for a
/// double one). Precondition: end > 0, c not empty, at most 64 coefficients.
std::vector<double> real_roots(std::span<const double> c, double end);

/// Σ c[i]·s^i
double polynomial_value(std::span<const double> c, double s);

/// The coefficients of the derivative. Precondition: at least two coefficients.
std::vector<double> derivative(std::span<const double> c);

/// False only where |Σ c[i]·s^i| > `slack` for 0 ≤ s ≤ `end`.
bool may_vanish(std::span<const double> c, double end, double slack);

}  // namespace gcs
