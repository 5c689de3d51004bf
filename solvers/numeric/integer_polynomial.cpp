#include "solvers/numeric/integer_polynomial.hpp"

#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <optional>

namespace gcs {
namespace {

/// Of each part of a root: more than a double has.
constexpr slong root_bits = 64;

/// The roots of a polynomial with simple ones, as a column.
BallMatrix balls_of_roots(const fmpz_poly_t squarefree, slong bits) {
  const slong count = fmpz_poly_degree(squarefree);
  const acb_ptr balls = _acb_vec_init(count);
  arb_fmpz_poly_complex_roots(balls, squarefree, 0, bits);
  BallMatrix column(count, 1);
  for (slong i = 0; i < count; ++i) acb_swap(column(i, 0), balls + i);
  _acb_vec_clear(balls, count);
  return column;
}

/// Those of a polynomial with simple roots.
void append_roots(const fmpz_poly_t squarefree, int multiplicity, std::vector<PolynomialRoot>& roots) {
  const BallMatrix balls = balls_of_roots(squarefree, root_bits);
  for (slong i = 0; i < balls.rows(); ++i) {
    const acb_srcptr ball = balls(i, 0);
    const auto middle = [](const arb_t part) { return arf_get_d(arb_midref(part), ARF_RND_NEAR); };
    roots.push_back({{middle(acb_realref(ball)), middle(acb_imagref(ball))},
                     arb_is_zero(acb_imagref(ball)) != 0,
                     multiplicity});
  }
}

/// Calls take(factor, multiplicity) for polynomials with simple roots, no two with a common one.
template <class Take>
void for_squarefree_factors(const fmpz_poly_t polynomial, const Take& take) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor_squarefree(factors, polynomial);
  for (slong i = 0; i < factors->num; ++i) take(factors->p + i, static_cast<int>(factors->exp[i]));
  fmpz_poly_factor_clear(factors);
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(const RationalPolynomial& polynomial, int variable)
    : IntegerPolynomial() {
  fmpq_poly_t rational;
  fmpq_poly_init(rational);
  for (const RationalPolynomial::Term& term : polynomial.terms())
    fmpq_poly_set_coeff_fmpq(rational, term.exponents[static_cast<std::size_t>(variable)],
                             term.coefficient.raw());
  fmpq_poly_get_numerator(value_, rational);
  fmpz_poly_primitive_part(value_, value_);
  fmpq_poly_clear(rational);
}

Rational IntegerPolynomial::value(const Rational& x) const {
  fmpq_t value;
  fmpq_init(value);
  fmpz_poly_evaluate_fmpq(value, value_, x.raw());
  const Rational result = Rational::from_raw(value);
  fmpq_clear(value);
  return result;
}

int IntegerPolynomial::real_root_count() const {
  int count = 0;
  for_squarefree_factors(value_, [&count](const fmpz_poly_struct* factor, int) {
    count += static_cast<int>(fmpz_poly_num_real_roots_sturm(factor));
  });
  return count;
}

std::vector<PolynomialRoot> IntegerPolynomial::roots() const {
  std::vector<PolynomialRoot> roots;
  for_squarefree_factors(value_, [&roots](const fmpz_poly_struct* factor, int multiplicity) {
    append_roots(factor, multiplicity, roots);
  });
  return roots;
}

BallMatrix IntegerPolynomial::simple_roots(slong bits) const {
  std::optional<BallMatrix> roots;
  for_squarefree_factors(value_, [&](const fmpz_poly_struct* factor, int multiplicity) {
    if (multiplicity == 1) roots.emplace(balls_of_roots(factor, bits));
  });
  return roots ? *roots : BallMatrix(0, 1);
}

}  // namespace gcs
