#include "solvers/lanes/monomial_system.hpp"

namespace gcs {

ComplexVectorX jacobian_at(const MonomialSystem& system, const ComplexVectorX& coefficients,
                           const ComplexVectorX& x) {
  const int n = system.unknowns;
  ComplexVectorX jacobian(static_cast<std::size_t>(n * n));
  for (int e = 0; e < n; ++e) {
    for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
      const auto [u, v] = system.monomials[j];
      if (u < 0) continue;
      jacobian[e * n + u] += coefficients[j] * (v < 0 ? 1.0 : x[v]);
      if (v >= 0) jacobian[e * n + v] += coefficients[j] * x[u];
    }
  }
  return jacobian;
}

}  // namespace gcs
