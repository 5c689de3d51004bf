#include "solvers/numeric/rational_polynomial.hpp"

#include <stdexcept>

namespace gcs {
namespace {

struct Ring {
  Ring() { fmpq_mpoly_ctx_init(context, 2, ORD_LEX); }
  ~Ring() { fmpq_mpoly_ctx_clear(context); }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;
  fmpq_mpoly_ctx_t context;
};

}  // namespace

const fmpq_mpoly_ctx_struct* RationalPolynomial::ring() {
  static const Ring of_two_variables;
  return of_two_variables.context;
}

RationalPolynomial RationalPolynomial::variable(int number) {
  RationalPolynomial polynomial;
  fmpq_mpoly_gen(polynomial.value_, number, ring());
  return polynomial;
}

RationalPolynomial RationalPolynomial::divided_by(const RationalPolynomial& divisor) const {
  RationalPolynomial quotient;
  fmpq_mpoly_divides(quotient.value_, value_, divisor.value_, ring());
  return quotient;
}

RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial divisor;
  if (!fmpq_mpoly_gcd(divisor.value_, a.value_, b.value_, RationalPolynomial::ring()))
    throw std::overflow_error("the exponents of a common divisor do not fit");
  return divisor;
}

}  // namespace gcs
