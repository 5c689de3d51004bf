#pragma once
/// Whether a polynomial is positive between 0 and 1, by exact Bernstein coefficients (Lane, Riesenfeld 1981): on
/// [0, 1] it is a mean of them, and where an interval is halved they come as near to it as one likes.

#include <optional>
#include <vector>

#include "solvers/numeric/rational.hpp"

namespace gcs {

/// Nothing is a proof that Σ c[i]·t^i > 0 for 0 ≤ t ≤ 1. Else a t in [0, 1], to rounding, where it is not positive or
/// so nearly not that 2^-64 of the interval does not tell. Precondition: c is not empty.
std::optional<double> where_not_positive(const std::vector<Rational>& c);

}  // namespace gcs
