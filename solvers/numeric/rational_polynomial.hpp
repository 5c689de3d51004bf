#pragma once
/// Polynomials in x and y with rational coefficients, exactly.

#include <flint/fmpq_mpoly.h>

#include "solvers/numeric/rational.hpp"

namespace gcs {

class RationalPolynomial {
 public:
  RationalPolynomial(const Rational& constant) : RationalPolynomial() {
    fmpq_mpoly_set_fmpq(value_, constant.raw(), ring());
  }
  RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
    fmpq_mpoly_set(value_, other.value_, ring());
  }
  RationalPolynomial& operator=(const RationalPolynomial& other) {
    fmpq_mpoly_set(value_, other.value_, ring());
    return *this;
  }
  ~RationalPolynomial() { fmpq_mpoly_clear(value_, ring()); }

  /// x for 0, y for 1.
  static RationalPolynomial variable(int number);

  friend RationalPolynomial operator+(RationalPolynomial a, const RationalPolynomial& b) {
    fmpq_mpoly_add(a.value_, a.value_, b.value_, ring());
    return a;
  }
  friend RationalPolynomial operator-(RationalPolynomial a, const RationalPolynomial& b) {
    fmpq_mpoly_sub(a.value_, a.value_, b.value_, ring());
    return a;
  }
  friend RationalPolynomial operator*(RationalPolynomial a, const RationalPolynomial& b) {
    fmpq_mpoly_mul(a.value_, a.value_, b.value_, ring());
    return a;
  }

  bool is_constant() const { return fmpq_mpoly_is_fmpq(value_, ring()) != 0; }
  /// Precondition: it divides this one.
  RationalPolynomial divided_by(const RationalPolynomial& divisor) const;
  friend RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b);

 private:
  RationalPolynomial() { fmpq_mpoly_init(value_, ring()); }
  static const fmpq_mpoly_ctx_struct* ring();

  fmpq_mpoly_t value_;
};

/// The greatest one. Precondition: not both are 0.
RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b);

}  // namespace gcs
