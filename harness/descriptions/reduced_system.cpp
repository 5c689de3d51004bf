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
    while (replace_one());
    for (const Expansion& equation : equations_) reduced_.system.equations.push_back(written(equation));
    for (const auto& [unknown, form] : replaced_) reduced_.replaced.emplace(unknown, linear(form));
    return std::move(reduced_);
  }

 private:
  bool replace_one() {
    for (std::size_t e = 0; e < equations_.size(); ++e) {
      const auto found = replacement(equations_[e]);
      if (!found) continue;
      const auto& [unknown, form] = *found;
      equations_.erase(equations_.begin() + static_cast<std::ptrdiff_t>(e));
      for (Expansion& equation : equations_) equation = with(equation, unknown, form);
      for (auto& [other, known] : replaced_) known = with(known, unknown, form);
      replaced_.emplace(unknown, form);
      return true;
    }
    return false;
  }

  /// An unknown that the equation gives, and what it is.
  std::optional<std::pair<int, Expansion>> replacement(const Expansion& equation) {
    if (equation.empty() || equation.rbegin()->first == one) return std::nullopt;
    const bool is_linear =
        std::ranges::all_of(equation, [](const auto& term) { return term.first.second < 0; });
    return is_linear ? std::optional(from_linear(equation)) : root(equation);
  }

  /// That with the largest coefficient.
  static std::pair<int, Expansion> from_linear(Expansion equation) {
    const auto [factors, coefficient] = *std::ranges::max_element(
        equation, {}, [](const auto& term) { return term.first == one ? 0 : std::abs(term.second); });
    equation.erase(factors);
    for (auto& [others, value] : equation) value /= -coefficient;
    return {factors.first, std::move(equation)};
  }

  std::optional<std::pair<int, Expansion>> root(const Expansion& equation) {
    const auto [u, v] = equation.rbegin()->first;
    if (u != v || equation.size() != 2 || equation.begin()->first != one || !has_either_sign(u))
      return std::nullopt;
    const double square = -equation.begin()->second.real() / equation.rbegin()->second.real();
    if (square <= 0) return std::nullopt;
    signs_.add(mirror_[static_cast<std::size_t>(u)], false);
    return std::pair(u, Expansion{{one, std::sqrt(square)}});
  }

  /// Among the changes of signs that leave the unknowns that have one.
  bool has_either_sign(int unknown) const {
    SignEquations signs = signs_;
    return signs.add(mirror_[static_cast<std::size_t>(unknown)], true);
  }

  static Expansion with(const Expansion& equation, int unknown, const Expansion& form) {
    constexpr double cancelled = 1e-12;  // of what a coefficient is the sum of: less is rounding
    Expansion result, sizes;
    const auto factor = [&](int u) { return u == unknown ? form : Expansion{{{u, -1}, 1.0}}; };
    for (const auto& [factors, coefficient] : equation)
      for (const auto& [left, a] : factor(factors.first))
        for (const auto& [right, b] : factor(factors.second)) {
          const Factors both = std::minmax(left.first, right.first);
          const std::complex<double> product = coefficient * a * b;
          result[{both.second, both.first}] += product;
          sizes[{both.second, both.first}] += std::abs(product);
        }
    std::erase_if(result, [&](const auto& term) {
      return std::abs(term.second) <= cancelled * std::abs(sizes[term.first]);
    });
    return result;
  }

  static LinearForm linear(const Expansion& form) {
    LinearForm result;
    for (const auto& [factors, coefficient] : form)
      if (factors == one)
        result.constant = exactly(coefficient);
      else
        result.terms.push_back({factors.first, exactly(coefficient)});
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
  std::map<int, Expansion> replaced_;  ///< linear
  ReducedSystem reduced_;
};

}  // namespace

ReducedSystem reduced_system(const QuadraticSystem& system) { return Reduction(system).run(); }

}  // namespace gcs
