#pragma once
/// How many zeros of a quadratic system fall together at one of its zeros, by all that doubles tell.
///
/// Where the Jacobian leaves c directions t free, the other unknowns are series in t that solve as many equations, and what
/// is left are c power series g(t) (Lyapunov–Schmidt reduction). Differential operators of order k that vanish at 0 on all
/// multiples of g are the kernel of a matrix (Macaulay 1916). Where their number stops growing with k the zero is isolated and
/// that number its multiplicity; above the multiplicity that it has, if it is isolated, it is not (D. J. Bates,
/// J. D. Hauenstein, C. Peterson, A. J. Sommese, A numerical local dimension test for points on the solution set of a system
/// of polynomial equations, SIAM J. Numer. Anal. 47 (2009)).

#include <complex>
#include <optional>
#include <vector>

#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// Of the zero x, which is known to 1e-8 of the unknowns' size, 1, or better; `most` + 1 where it is more, or where the zero
/// is not isolated; nothing where the matrices become too large to say. Zeros so near x that doubles hardly tell them apart
/// count as if they were there.
std::optional<int> local_multiplicity(const QuadraticSystem& system,
                                      const std::vector<std::complex<double>>& x, int most);

}  // namespace gcs
