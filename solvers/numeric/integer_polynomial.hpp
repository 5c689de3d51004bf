#pragma once
/// Polynomials in one unknown with integer coefficients, by the library FLINT: how many roots are real is proven.

#include <flint/fmpz_poly.h>

#include <complex>
#include <vector>

#include "solvers/numeric/balls.hpp"
#include "solvers/numeric/rational_polynomial.hpp"

namespace gcs {

struct PolynomialRoot {
  std::complex<double> value;  ///< right to rounding; imaginary part 0 only where it is real
  bool is_real = false;        ///< proven, as is the opposite
  int multiplicity = 1;
};

class IntegerPolynomial {
 public:
  /// 0.
  IntegerPolynomial() { fmpz_poly_init(value_); }
  /// Without denominators and common factors of the coefficients: zeros are the same. Precondition: no other unknown
  /// than x_variable occurs.
  IntegerPolynomial(const RationalPolynomial& polynomial, int variable);
  IntegerPolynomial(const IntegerPolynomial& other) : IntegerPolynomial() {
    fmpz_poly_set(value_, other.value_);
  }
  IntegerPolynomial& operator=(const IntegerPolynomial& other) {
    fmpz_poly_set(value_, other.value_);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  /// −1: it is 0.
  int degree() const { return static_cast<int>(fmpz_poly_degree(value_)); }
  bool is_zero() const { return degree() < 0; }
  Rational value(const Rational& x) const;
  /// Whether all roots are simple. Precondition: not 0.
  bool is_squarefree() const { return fmpz_poly_is_squarefree(value_) != 0; }
  /// Distinct ones, by Sturm's theorem. Precondition: not 0.
  int real_root_count() const;
  /// All distinct ones, each isolated in a ball. Precondition: not 0.
  std::vector<PolynomialRoot> roots() const;
  /// The simple ones as a column, in balls of that many bits. Precondition: not 0.
  BallMatrix simple_roots(slong bits) const;

 private:
  fmpz_poly_t value_;
};

}  // namespace gcs
