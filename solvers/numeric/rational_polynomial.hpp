#pragma once
/// Polynomials in several unknowns with rational coefficients, exactly.

#include <flint/fmpq_mpoly.h>

#include <vector>

#include "solvers/numeric/rational.hpp"

namespace gcs {

class RationalPolynomial {
 public:
  /// Of all polynomials, whichever of them occur.
  static constexpr int variables = 16;

  /// coefficient·Π x_i^exponents[i]
  struct Term {
    std::vector<int> exponents;  ///< `variables` of them
    Rational coefficient;
  };

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

  /// x_number. Precondition: 0 ≤ number < variables.
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
  bool is_zero() const { return fmpq_mpoly_is_zero(value_, ring()) != 0; }
  /// In all unknowns together; −1: it is 0.
  int total_degree() const { return static_cast<int>(fmpq_mpoly_total_degree_si(value_, ring())); }
  /// Those whose coefficient is not 0, in lexicographic order from the highest on.
  std::vector<Term> terms() const;
  /// At x_i = point[i]; unknowns beyond the point's are 0.
  Rational value(const std::vector<Rational>& point) const;
  /// Precondition: it divides this one.
  RationalPolynomial divided_by(const RationalPolynomial& divisor) const;
  friend RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b);
  friend RationalPolynomial resultant(const RationalPolynomial& a, const RationalPolynomial& b, int variable);

 private:
  RationalPolynomial() { fmpq_mpoly_init(value_, ring()); }
  static const fmpq_mpoly_ctx_struct* ring();

  fmpq_mpoly_t value_;
};

/// The greatest one. Precondition: not both are 0.
RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b);

/// Of both as polynomials in x_variable, of the degrees that they have: it vanishes where they have a common zero,
/// one at infinity included, and is 0 where they have a common factor.
RationalPolynomial resultant(const RationalPolynomial& a, const RationalPolynomial& b, int variable);

}  // namespace gcs
