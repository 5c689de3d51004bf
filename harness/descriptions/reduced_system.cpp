#include "harness/descriptions/reduced_system.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solvers/homotopies/general_family.hpp"
#include "solvers/polyhedral/eliminated_equations.hpp"

namespace gcs {
namespace {

using Factors = std::pair<int, int>;

const Factors one{-1, -1};

Factors factors_of(const Exponents& exponents) {
  std::vector<int> factors;
  for (std::size_t u = exponents.size(); u-- > 0;)
    factors.insert(factors.end(), static_cast<std::size_t>(exponents[u]), static_cast<int>(u));
  factors.resize(2, -1);
  return {factors[0], factors[1]};
}

std::vector<Expansion> eliminated(const std::vector<Expansion>& equations, int unknowns) {
  MonomialSystem system;
  system.unknowns = unknowns;
  ComplexVectorX coefficients;
  for (const Expansion& equation : equations) {
    for (const auto& [factors, coefficient] : equation) {
      if (coefficient == 0.0) continue;
      system.monomials.push_back({factors.first, factors.second});
      coefficients.push_back(coefficient);
    }
    system.first.push_back(static_cast<int>(coefficients.size()));
  }
  const EliminatedEquations echelon = eliminated_equations(system, coefficients);
  std::vector<Expansion> result;
  auto coefficient = echelon.coefficients.begin();
  for (const Support& support : echelon.supports) {
    result.emplace_back();
    for (const Exponents& exponents : support) result.back()[factors_of(exponents)] = *coefficient++;
  }
  return result;
}

class Reduction {
 public:
  explicit Reduction(const QuadraticSystem& system) : mirror_(system.mirror) {
    reduced_.system.unknowns = system.unknowns;
    reduced_.system.mirror = system.mirror;
    for (const QuadraticEquation& equation : system.equations) equations_.push_back(expanded(equation));
  }

  ReducedSystem run() {
    do equations_ = eliminated(equations_, reduced_.system.unknowns);
    while (put_number());
    for (const Expansion& equation : equations_) reduced_.system.equations.push_back(written(equation));
    return std::move(reduced_);
  }

 private:
  bool put_number() {
    for (std::size_t e = 0; e < equations_.size(); ++e) {
      const auto found = number(equations_[e]);
      if (!found) continue;
      equations_.erase(equations_.begin() + static_cast<std::ptrdiff_t>(e));
      reduced_.numbers.insert(*found);
      for (Expansion& equation : equations_) equation = with_number(equation, found->first, found->second);
      return true;
    }
    return false;
  }

  /// The unknown that the equation gives, with its value.
  std::optional<std::pair<int, double>> number(const Expansion& equation) {
    if (equation.empty() || equation.rbegin()->first == one) return std::nullopt;
    const auto [u, v] = equation.rbegin()->first;
    if (equation.size() > 2 || (equation.size() == 2 && equation.begin()->first != one)) return std::nullopt;
    const double constant = equation.size() == 2 ? equation.begin()->second.real() : 0;
    const double value = -constant / equation.rbegin()->second.real();
    if (v < 0) return std::pair(u, value);
    if (u != v || value <= 0 || !has_either_sign(u)) return std::nullopt;
    signs_.add(mirror_[static_cast<std::size_t>(u)], false);
    return std::pair(u, std::sqrt(value));
  }

  /// Among the changes of signs that leave the unknowns that are numbers.
  bool has_either_sign(int unknown) const {
    SignEquations signs = signs_;
    return signs.add(mirror_[static_cast<std::size_t>(unknown)], true);
  }

  static Expansion with_number(const Expansion& equation, int unknown, double value) {
    constexpr double cancelled = 1e-12;  // of what a coefficient is the sum of: less is rounding
    Expansion result, sizes;
    for (const auto& [monomial, before] : equation) {
      Factors factors = monomial;
      std::complex<double> coefficient = before;
      for (int* factor : {&factors.first, &factors.second})
        if (*factor == unknown) {
          *factor = -1;
          coefficient *= value;
        }
      if (factors.first < factors.second) std::swap(factors.first, factors.second);
      result[factors] += coefficient;
      sizes[factors] += std::abs(coefficient);
    }
    std::erase_if(result, [&](const auto& term) {
      return std::abs(term.second) <= cancelled * std::abs(sizes[term.first]);
    });
    return result;
  }

  static QuadraticEquation written(const Expansion& equation) {
    QuadraticEquation result;
    for (const auto& [factors, coefficient] : equation) {
      if (factors == one) {
        result.given = exactly(-coefficient);
        continue;
      }
      const LinearForm left{{{factors.first, exactly(coefficient)}}, {}};
      const LinearForm right =
          factors.second < 0 ? LinearForm{{}, exactly(1)} : LinearForm{{{factors.second}}, {}};
      result.products.push_back({left, right});
    }
    return result;
  }

  SignMasks mirror_;
  SignEquations signs_;
  std::vector<Expansion> equations_;
  ReducedSystem reduced_;
};

}  // namespace

ReducedSystem reduced_system(const QuadraticSystem& system) { return Reduction(system).run(); }

}  // namespace gcs
