#include "solvers/numeric/rational_polynomial.hpp"

#include <array>
#include <stdexcept>

namespace gcs {
namespace {

struct Ring {
  Ring() { fmpq_mpoly_ctx_init(context, RationalPolynomial::variables, ORD_LEX); }
  ~Ring() { fmpq_mpoly_ctx_clear(context); }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;
  fmpq_mpoly_ctx_t context;
};

}  // namespace

const fmpq_mpoly_ctx_struct* RationalPolynomial::ring() {
  static const Ring of_all;
  return of_all.context;
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

std::vector<RationalPolynomial::Term> RationalPolynomial::terms() const {
  std::vector<Term> terms;
  fmpq_t coefficient;
  fmpq_init(coefficient);
  for (slong i = 0; i < fmpq_mpoly_length(value_, ring()); ++i) {
    std::array<slong, variables> exponents{};
    fmpq_mpoly_get_term_exp_si(exponents.data(), value_, i, ring());
    fmpq_mpoly_get_term_coeff_fmpq(coefficient, value_, i, ring());
    terms.push_back({{exponents.begin(), exponents.end()}, Rational::from_raw(coefficient)});
  }
  fmpq_clear(coefficient);
  return terms;
}

Rational RationalPolynomial::value(const std::vector<Rational>& point) const {
  Rational sum;
  for (const Term& term : terms()) {
    Rational product = term.coefficient;
    for (std::size_t i = 0; i < term.exponents.size(); ++i)
      for (int k = 0; k < term.exponents[i]; ++k)
        product = product * (i < point.size() ? point[i] : Rational(0));
    sum = sum + product;
  }
  return sum;
}

RationalPolynomial resultant(const RationalPolynomial& a, const RationalPolynomial& b, int variable) {
  RationalPolynomial result;
  if (!fmpq_mpoly_resultant(result.value_, a.value_, b.value_, variable, RationalPolynomial::ring()))
    throw std::overflow_error("the exponents of a resultant do not fit");
  return result;
}

RationalPolynomial common_divisor(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial divisor;
  if (!fmpq_mpoly_gcd(divisor.value_, a.value_, b.value_, RationalPolynomial::ring()))
    throw std::overflow_error("the exponents of a common divisor do not fit");
  return divisor;
}

}  // namespace gcs
