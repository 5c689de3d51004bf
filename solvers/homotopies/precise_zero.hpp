#pragma once
/// Zeros to some 50 digits: residuals in high precision, steps by one Jacobian factorised in doubles (iterative
/// refinement; Tisseur, Newton's method in floating point arithmetic, SIAM J. Matrix Anal. Appl. 22 (2001)).

#include <optional>

#include "solvers/lanes/monomial_system.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {

/// So many that 1e-50 of the size is left of zeros at 1e11, where residuals cancel to 1e-22 of their terms, and more.
inline constexpr slong precise_bits_of_zeros = 320;

/// The zero next to x, which is one to the precision of doubles, as a column without radii: to 1e-50 of its size. Nothing
/// where steps do not shrink, at condition numbers of 1e15 or so.
std::optional<BallMatrix> precise_zero(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                       const ComplexVectorX& x);
std::optional<BallMatrix> precise_zero(const SquareSystem& system, const ComplexVectorX& squares,
                                       const ComplexVectorX& x);

/// Adds coefficient · x[u]·x[v] to the sum.
void add_monomial(acb_ptr sum, const std::complex<double>& coefficient, const Monomial& monomial,
                  const BallMatrix& x);

}  // namespace gcs
