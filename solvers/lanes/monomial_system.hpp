#pragma once
/// Sparse systems f_e(x; c) = Σ c_j·x_u·x_v in C^n, whose parameters are all their coefficients.

#include <vector>

#include "solvers/lanes/square_system.hpp"

namespace gcs {

/// x[u]·x[v]; −1 stands for a factor 1, and v is −1 where u is.
struct Monomial {
  int u = -1;
  int v = -1;
};

struct MonomialSystem {
  int unknowns = 0;
  std::vector<Monomial> monomials;  ///< those of equation e are first[e] … first[e + 1] − 1
  std::vector<int> first{0};
  /// Of each monomial the first of its equation that has the same coefficient along every path; empty: each itself.
  std::vector<int> shares{};

  int equations() const { return static_cast<int>(first.size()) - 1; }
  /// The monomial whose coefficient monomial j has.
  int leader(int j) const { return shares.empty() ? j : shares[j]; }
};

/// The equations as Σ c·(sum of monomials): monomials with one coefficient are a sum, and sums that several equations have
/// stand here once.
struct MonomialSums {
  struct Term {
    int coefficient = 0;  ///< that of this monomial of the system
    int sum = 0;
  };

  std::vector<std::vector<Monomial>> sums;
  std::vector<Term> terms;
  std::vector<int> first{0};  ///< those of equation e are first[e] … first[e + 1] − 1
};
MonomialSums monomial_sums(const MonomialSystem& system);

/// At x.
inline std::complex<double> monomial_at(const Monomial& monomial, const ComplexVectorX& x) {
  return (monomial.u < 0 ? 1.0 : x[monomial.u]) * (monomial.v < 0 ? 1.0 : x[monomial.v]);
}

/// f_e(x; c), one per equation, and the sizes of its terms together.
struct EquationValues {
  ComplexVectorX value;
  std::vector<double> size;
};
EquationValues values_at(const MonomialSystem& system, const ComplexVectorX& coefficients,
                         const ComplexVectorX& x);

/// Whether the error of a singular end, the root of rounding, explains what x misses of 0 in every equation.
bool is_zero_at(const MonomialSystem& system, const ComplexVectorX& coefficients, const ComplexVectorX& x);

/// df_e/dx_i for these coefficients, one per monomial, row by row.
ComplexVectorX jacobian_at(const MonomialSystem& system, const ComplexVectorX& coefficients,
                           const ComplexVectorX& x);

}  // namespace gcs
