#include "solvers/lanes/monomial_system.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gcs {

MonomialSums monomial_sums(const MonomialSystem& system) {
  MonomialSums result;
  std::map<std::vector<std::pair<int, int>>, int> numbers;
  for (int e = 0; e < system.equations(); ++e) {
    std::map<int, std::vector<std::pair<int, int>>> with_coefficient;
    for (int j = system.first[e]; j < system.first[e + 1]; ++j)
      with_coefficient[system.leader(j)].emplace_back(system.monomials[j].u, system.monomials[j].v);
    for (auto& [coefficient, monomials] : with_coefficient) {
      std::sort(monomials.begin(), monomials.end());
      const auto [known, is_new] = numbers.try_emplace(monomials, static_cast<int>(result.sums.size()));
      if (is_new) {
        std::vector<Monomial>& sum = result.sums.emplace_back();
        for (const auto& [u, v] : monomials) sum.push_back({u, v});
      }
      result.terms.push_back({coefficient, known->second});
    }
    result.first.push_back(static_cast<int>(result.terms.size()));
  }
  return result;
}

EquationValues values_at(const MonomialSystem& system, const ComplexVectorX& coefficients,
                         const ComplexVectorX& x) {
  const auto equations = static_cast<std::size_t>(system.equations());
  EquationValues result{ComplexVectorX(equations), std::vector<double>(equations)};
  for (std::size_t e = 0; e < equations; ++e)
    for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
      const std::complex<double> term = coefficients[j] * monomial_at(system.monomials[j], x);
      result.value[e] += term;
      result.size[e] += std::abs(term);
    }
  return result;
}

bool is_zero_at(const MonomialSystem& system, const ComplexVectorX& coefficients, const ComplexVectorX& x) {
  constexpr double tolerance = 1e-9;  // of the terms' sizes; ends that a mean lies between are further apart
  const EquationValues here = values_at(system, coefficients, x);
  for (std::size_t e = 0; e < here.value.size(); ++e)
    if (!(std::abs(here.value[e]) <= tolerance * here.size[e])) return false;
  return true;
}

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
