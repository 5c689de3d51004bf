#pragma once
/// Square systems of polynomials with exact coefficients, and what is counted of them.

#include <string>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/numeric/rational_polynomial.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

struct PolynomialSystem {
  int unknowns = 0;                           ///< x_0 … x_(unknowns − 1)
  std::vector<RationalPolynomial> equations;  ///< as many; each = 0

  /// Terms of all equations.
  int terms() const;
  /// Bézout's number: the product of the degrees. Precondition: no equation is 0.
  Natural total_degree() const;
};

/// The monomials of each equation, in the order of its terms.
Supports supports_of(const PolynomialSystem& system);

/// The coefficients in the same order, each equation divided by its largest one.
std::vector<ComplexVectorX> coefficients_of(const PolynomialSystem& system);

/// The equations' reduced echelon form in their monomials, those of the highest degree eliminated first: Gaussian
/// elimination, the first step of the systematic simplification of C. Durand, C. M. Hoffmann, J. Symb. Comput. 30
/// (2000). The same zeros; equations that depend on the others are left out.
PolynomialSystem echelon_form(const PolynomialSystem& system);

/// For writing systems down.
RationalPolynomial squared(const RationalPolynomial& polynomial);

}  // namespace gcs
