#pragma once
/// Solutions in fractions, of which exact arithmetic shows what no enclosure can: that all solutions of a cluster are one.

#include <complex>
#include <optional>
#include <vector>

#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/balls.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {

/// The fractions with the least denominators that are no further from the numbers x than `radius`; nothing where one of these
/// is further from the reals. Precondition: finite.
std::optional<std::vector<Rational>> simplest_fractions(const std::vector<std::complex<double>>& x,
                                                        const std::vector<double>& radius);

/// The fractions as a column.
BallMatrix enclosed(const std::vector<Rational>& x, slong bits);

/// An isolated zero x has this multiplicity at least; 0: x is no zero, or the system has coefficients that are no fractions.
///
/// Where the Jacobian loses r from its rank: 2^r, as the multiplicity is at least the product of the orders of r power series
/// in r variables that elimination leaves, none of which has a linear term (Fulton, Intersection Theory, 1998, corollary 12.4). Where
/// r = 1: d, if f vanishes to order d along a curve x(b) with x'(0) ≠ 0, as the local ring has C[b]/b^d as a quotient then. Up
/// to `most`.
int least_multiplicity(const QuadraticSystem& system, const std::vector<Rational>& x, int most);

}  // namespace gcs
