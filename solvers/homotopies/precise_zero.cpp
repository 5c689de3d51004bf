#include "solvers/homotopies/precise_zero.hpp"

#include <Eigen/LU>
#include <limits>

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr slong bits = precise_bits_of_zeros;

ComplexVectorX precise_residual(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                const BallMatrix& x) {
  ComplexVectorX residual;
  for (int e = 0; e < system.equations(); ++e) {
    Ball sum;
    for (int j = system.first[e]; j < system.first[e + 1]; ++j)
      add_monomial(sum, coefficients[j], system.monomials[j], x);
    residual.push_back(rounded_midpoint(sum));
  }
  return residual;
}

void add_square(acb_ptr sum, const Difference& square, const BallMatrix& x) {
  Ball difference;
  if (square.subtrahend < 0)
    acb_set_d(difference, square.constant);
  else
    acb_set(difference, x(square.subtrahend, 0));
  acb_sub(difference, x(square.minuend, 0), difference, bits);
  acb_addmul(sum, difference, difference, bits);
}

/// Half of the sums, as the Jacobian is.
ComplexVectorX precise_residual(const SquareSystem& system, const ComplexVectorX& squares,
                                const BallMatrix& x) {
  ComplexVectorX residual;
  for (int e = 0; e < system.equations(); ++e) {
    Ball sum;
    add_monomial(sum, -squares[e], {}, x);
    add_monomial(sum, system.given[e], {}, x);
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) add_square(sum, system.differences[d], x);
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      add_monomial(sum, system.linear[l].coefficient, {system.linear[l].unknown, -1}, x);
    residual.push_back(rounded_midpoint(sum) / 2.0);
  }
  return residual;
}

void subtract(BallMatrix& x, const Eigen::VectorXcd& change) {
  Ball step;
  for (slong i = 0; i < x.rows(); ++i) {
    acb_set_d_d(step, change[i].real(), change[i].imag());
    acb_sub(x(i, 0), x(i, 0), step, bits);
  }
  acb_mat_get_mid(x.get(), x.get());
}

/// `jacobian`: at x, row by row.
template <class System>
std::optional<BallMatrix> refined(const System& system, const ComplexVectorX& parameters,
                                  const ComplexVectorX& jacobian, const ComplexVectorX& x) {
  constexpr int most_steps = 60;
  constexpr double settled = 1e-50;
  using Rows = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::PartialPivLU<Rows> factors(Eigen::Map<const Rows>(jacobian.data(), n, n));
  BallMatrix zero(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) acb_set_d_d(zero(i, 0), x[i].real(), x[i].imag());
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps && last > settled; ++step) {
    const ComplexVectorX residual = precise_residual(system, parameters, zero);
    const Eigen::VectorXcd change = factors.solve(Eigen::Map<const Eigen::VectorXcd>(residual.data(), n));
    const double correction = change.cwiseAbs().maxCoeff() / (1 + largest(x));
    if (!change.allFinite() || correction > last / 2) return std::nullopt;
    subtract(zero, change);
    last = correction;
  }
  return last <= settled ? std::optional(zero) : std::nullopt;
}

}  // namespace

void add_monomial(acb_ptr sum, const Complex& coefficient, const Monomial& monomial, const BallMatrix& x) {
  Ball term;
  acb_set_d_d(term, coefficient.real(), coefficient.imag());
  if (monomial.u >= 0) acb_mul(term, term, x(monomial.u, 0), bits);
  if (monomial.v >= 0) acb_mul(term, term, x(monomial.v, 0), bits);
  acb_add(sum, sum, term, bits);
}

std::optional<BallMatrix> precise_zero(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                       const ComplexVectorX& x) {
  return refined(system, coefficients, jacobian_at(system, coefficients, x), x);
}

std::optional<BallMatrix> precise_zero(const SquareSystem& system, const ComplexVectorX& squares,
                                       const ComplexVectorX& x) {
  return refined(system, squares, jacobian_at(system, x), x);
}

}  // namespace gcs
