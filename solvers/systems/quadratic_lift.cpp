#include "solvers/systems/quadratic_lift.hpp"

#include <algorithm>
#include <map>

namespace gcs {
namespace {

/// A monomial as its factors, ascending.
using Factors = std::vector<int>;

Factors factors_of(const Exponents& exponents) {
  Factors factors;
  for (std::size_t v = 0; v < exponents.size(); ++v)
    factors.insert(factors.end(), static_cast<std::size_t>(exponents[v]), static_cast<int>(v));
  return factors;
}

/// The product of two unknowns that most monomials with more than two factors have; of equal ones the first.
std::array<int, 2> commonest_product(const std::vector<std::vector<Factors>>& equations) {
  std::map<std::array<int, 2>, int> uses;
  for (const std::vector<Factors>& equation : equations)
    for (const Factors& factors : equation) {
      if (factors.size() <= 2) continue;
      std::map<std::array<int, 2>, int> here;
      for (std::size_t i = 0; i < factors.size(); ++i)
        for (std::size_t j = i + 1; j < factors.size(); ++j) here[{factors[i], factors[j]}] = 1;
      for (const auto& [product, once] : here) uses[product] += once;
    }
  return std::max_element(uses.begin(), uses.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Puts unknown `name` for u·v, as often as there are more than two factors.
void substitute(const std::array<int, 2>& product, int name, Factors& factors) {
  while (factors.size() > 2) {
    const auto u = std::find(factors.begin(), factors.end(), product[0]);
    if (u == factors.end()) return;
    const auto v = std::find(u + 1, factors.end(), product[1]);
    if (v == factors.end()) return;
    factors.erase(v);
    factors.erase(u);
    factors.push_back(name);
  }
}

bool has_long(const std::vector<std::vector<Factors>>& equations) {
  return std::any_of(equations.begin(), equations.end(), [](const std::vector<Factors>& equation) {
    return std::any_of(equation.begin(), equation.end(),
                       [](const Factors& factors) { return factors.size() > 2; });
  });
}

Exponents exponents_of(const Factors& factors, std::size_t unknowns) {
  Exponents exponents(unknowns, 0);
  for (const int factor : factors) ++exponents[static_cast<std::size_t>(factor)];
  return exponents;
}

}  // namespace

ComplexVectorX QuadraticLift::lifted(ComplexVectorX x) const {
  for (const auto& [u, v] : products)
    x.push_back(x[static_cast<std::size_t>(u)] * x[static_cast<std::size_t>(v)]);
  return x;
}

QuadraticLift quadratic_lift(const Supports& supports) {
  QuadraticLift lift;
  lift.unknowns = static_cast<int>(supports.size());
  std::vector<std::vector<Factors>> equations;
  for (const Support& support : supports) {
    std::vector<Factors>& equation = equations.emplace_back();
    for (const Exponents& exponents : support) equation.push_back(factors_of(exponents));
  }
  while (has_long(equations)) {
    const std::array<int, 2> product = commonest_product(equations);
    const int name = lift.unknowns + static_cast<int>(lift.products.size());
    for (std::vector<Factors>& equation : equations)
      for (Factors& factors : equation) substitute(product, name, factors);
    lift.products.push_back(product);
  }
  const std::size_t unknowns = supports.size() + lift.products.size();
  for (const std::vector<Factors>& equation : equations) {
    Support& support = lift.supports.emplace_back();
    for (const Factors& factors : equation) support.push_back(exponents_of(factors, unknowns));
  }
  for (std::size_t k = 0; k < lift.products.size(); ++k) {
    const auto [u, v] = lift.products[k];
    lift.supports.push_back(
        {exponents_of({lift.unknowns + static_cast<int>(k)}, unknowns), exponents_of({u, v}, unknowns)});
  }
  return lift;
}

}  // namespace gcs
