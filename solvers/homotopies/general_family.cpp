#include "solvers/homotopies/general_family.hpp"

#include <Eigen/LU>
#include <stdexcept>
#include <utility>

#include "solvers/elements/dense_equations.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

void add_term(Expansion& expansion, int u, int v, Complex coefficient) {
  if (u < v) std::swap(u, v);
  expansion[{u, v}] += coefficient;
}

void add_product(Expansion& expansion, const LinearForm& left, const LinearForm& right) {
  const auto terms = [](const LinearForm& form) {
    std::vector<std::pair<int, Complex>> result;
    for (const ScaledUnknown& term : form.terms)
      result.emplace_back(term.unknown, rounded_to_double(term.coefficient));
    if (!form.constant.is_zero()) result.emplace_back(-1, rounded_to_double(form.constant));
    return result;
  };
  for (const auto& [u, a] : terms(left))
    for (const auto& [v, b] : terms(right)) add_term(expansion, u, v, a * b);
}

/// Of the products of numbers alone.
Complex constant_of(const QuadraticEquation& equation) {
  Complex sum = 0;
  for (const FormProduct& product : equation.products)
    sum += rounded_to_double(product.left.constant) * rounded_to_double(product.right.constant);
  return sum;
}

/// The equations that have no value.
std::vector<int> without_value(const GeneralEquations& equations) {
  std::vector<int> result;
  for (int e = 0; e < equations.system.equations(); ++e)
    if (equations.value_monomial[e] < 0) result.push_back(e);
  return result;
}

/// The coefficient that the first monomial of each equation has makes it zero.
FamilyMember random_zero_of_coefficients(const MonomialSystem& system, std::mt19937_64& random) {
  FamilyMember member{random_complex_vector(system.unknowns, random),
                      random_complex_vector(static_cast<int>(system.monomials.size()), random)};
  for (int e = 0; e < system.equations(); ++e) {
    const int first = system.first[e];
    Complex with_first = 0, others = 0;
    for (int j = first; j < system.first[e + 1]; ++j) {
      const Complex monomial = monomial_at(system.monomials[j], member.x);
      if (system.leader(j) == first)
        with_first += monomial;
      else
        others += member.parameters[system.leader(j)] * monomial;
    }
    member.parameters[first] = -others / with_first;
    for (int j = first; j < system.first[e + 1]; ++j)
      member.parameters[j] = member.parameters[system.leader(j)];
  }
  return member;
}

}  // namespace

Expansion expanded(const QuadraticEquation& equation) {
  Expansion expansion;
  for (const FormProduct& product : equation.products) add_product(expansion, product.left, product.right);
  add_term(expansion, -1, -1, -rounded_to_double(equation.given));
  return expansion;
}

GeneralEquations general_equations(const SceneSystem& scene) {
  GeneralEquations result;
  result.system.unknowns = scene.equations().unknowns;
  result.signs = scene.equations().mirror;
  result.exact = scene.equations();
  for (std::size_t e = 0; e < scene.equations().equations.size(); ++e) {
    const bool has_value = scene.value_of()[e] != no_value;
    result.constants.push_back(constant_of(scene.equations().equations[e]));
    result.value_monomial.push_back(-1);
    for (const auto& [monomial, coefficient] : expanded(scene.equations().equations[e])) {
      const bool is_constant = monomial.first < 0;
      if (coefficient == 0.0 && !(is_constant && has_value)) continue;
      if (is_constant && has_value)
        result.value_monomial.back() = static_cast<int>(result.coefficients.size());
      result.system.monomials.push_back({monomial.first, monomial.second});
      result.coefficients.push_back(coefficient);
    }
    result.system.first.push_back(static_cast<int>(result.coefficients.size()));
  }
  return result;
}

GeneralEquations sharing_coefficients(GeneralEquations equations) {
  MonomialSystem& system = equations.system;
  for (int e = 0; e < system.equations(); ++e) {
    const auto share = [&, value = equations.value_monomial[e]](int i, int j) {
      const bool is_alone = i == value || j == value;
      return i == j || (!is_alone && equations.coefficients[i] == equations.coefficients[j]);
    };
    for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
      int first = system.first[e];
      while (!share(first, j)) ++first;
      system.shares.push_back(first);
    }
  }
  return equations;
}

ComplexVectorX values_of(const GeneralEquations& equations, const ComplexVectorX& coefficients) {
  ComplexVectorX values;
  for (std::size_t e = 0; e < equations.value_monomial.size(); ++e)
    if (const int j = equations.value_monomial[e]; j >= 0)
      values.push_back(equations.constants[e] - coefficients[j]);
  return values;
}

ComplexVectorX with_values(const GeneralEquations& equations, const ComplexVectorX& values) {
  ComplexVectorX coefficients = equations.coefficients;
  std::size_t next = 0;
  for (std::size_t e = 0; e < equations.value_monomial.size(); ++e)
    if (const int j = equations.value_monomial[e]; j >= 0)
      coefficients[j] = equations.constants[e] - values[next++];
  return coefficients;
}

FamilyMember random_member(const GeneralEquations& equations, std::mt19937_64& random) {
  auto x = random_zero(DenseEquations(equations.exact), without_value(equations), random);
  if (!x) throw std::runtime_error("no figure at random meets the constraints without a value");
  FamilyMember member{std::move(*x), equations.coefficients};
  const ComplexVectorX value = values_at(equations.system, equations.coefficients, member.x).value;
  for (int e = 0; e < equations.system.equations(); ++e)
    if (const int j = equations.value_monomial[e]; j >= 0) member.parameters[j] -= value[e];
  return member;
}

HomotopyFamily family_of(const GeneralEquations& equations) {
  std::vector<bool> is_free(equations.coefficients.size(), false);
  for (const int j : equations.value_monomial)
    if (j >= 0) is_free[j] = true;
  return {equations.signs, std::move(is_free), false,
          [&equations](std::mt19937_64& random) { return random_member(equations, random); }};
}

HomotopyFamily family_of_coefficients(const GeneralEquations& equations) {
  const MonomialSystem& system = equations.system;
  std::vector<bool> is_free;
  for (int j = 0; j < static_cast<int>(system.monomials.size()); ++j)
    is_free.push_back(system.leader(j) == j);
  return {equations.signs, std::move(is_free), false,
          [&system](std::mt19937_64& random) { return random_zero_of_coefficients(system, random); }};
}

Elimination order_elimination(const MonomialSystem& system, const HomotopyFamily& family,
                              std::mt19937_64& random) {
  constexpr int samples = 3;
  std::vector<ComplexVectorX> jacobians;
  for (int i = 0; i < samples; ++i) {
    const FamilyMember member = family.random_member(random);
    jacobians.push_back(jacobian_at(system, member.parameters, member.x));
  }
  return order_elimination(system, jacobians);
}

bool newton(const MonomialSystem& system, const ComplexVectorX& coefficients, ComplexVectorX& x) {
  constexpr int most_iterations = 8;
  constexpr double settled = 1e-13, settled_at_all = 1e-6;
  using Rows = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(x.size());
  double last = 1;
  for (int i = 0; i < most_iterations; ++i) {
    const ComplexVectorX jacobian = jacobian_at(system, coefficients, x);
    const ComplexVectorX value = values_at(system, coefficients, x).value;
    const Eigen::PartialPivLU<Rows> factors(Eigen::Map<const Rows>(jacobian.data(), n, n));
    const Eigen::VectorXcd change = factors.solve(Eigen::Map<const Eigen::VectorXcd>(value.data(), n));
    if (!change.allFinite()) return false;
    Eigen::Map<Eigen::VectorXcd>(x.data(), n) -= change;
    const double correction = change.cwiseAbs().maxCoeff() / (1 + largest(x));
    if (correction <= settled) return true;
    if (i > 2 && correction > last / 2) return correction <= settled_at_all;
    last = correction;
  }
  return last <= settled_at_all;
}

}  // namespace gcs
