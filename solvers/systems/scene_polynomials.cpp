#include "solvers/systems/scene_polynomials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

bool has_cosine(const LinearForm& form) {
  return form.constant.is_cosine_of_degrees || std::ranges::any_of(form.terms, [](const ScaledUnknown& term) {
           return term.coefficient.is_cosine_of_degrees;
         });
}

bool has_cosine(const QuadraticEquation& equation) {
  return equation.given.is_cosine_of_degrees ||
         std::ranges::any_of(equation.products, [](const FormProduct& product) {
           return has_cosine(product.left) || has_cosine(product.right);
         });
}

RationalPolynomial polynomial(const LinearForm& form) {
  RationalPolynomial sum = *fraction(form.constant);
  for (const ScaledUnknown& term : form.terms)
    sum = sum + *fraction(term.coefficient) * RationalPolynomial::variable(term.unknown);
  return sum;
}

}  // namespace

std::optional<std::string> why_no_polynomials(const QuadraticSystem& system) {
  if (system.unknowns > RationalPolynomial::variables)
    return fmt::format("its equations have {} unknowns; they are written down for {} at most",
                       system.unknowns, RationalPolynomial::variables);
  if (std::ranges::any_of(system.equations, [](const auto& equation) { return has_cosine(equation); }))
    return "the cosines of angles in degrees are no fractions, with which its equations are written down: "
           "give cosines";
  if (!std::ranges::all_of(system.equations, has_fractions))
    return "directions of length 1 make roots that are no fractions, with which its equations are written "
           "down";
  return std::nullopt;
}

PolynomialSystem polynomials_of(const QuadraticSystem& system) {
  PolynomialSystem result;
  result.unknowns = system.unknowns;
  for (const QuadraticEquation& equation : system.equations) {
    RationalPolynomial sum = Rational(-1) * *fraction(equation.given);
    for (const FormProduct& product : equation.products)
      sum = sum + polynomial(product.left) * polynomial(product.right);
    result.equations.push_back(sum);
  }
  return result;
}

}  // namespace gcs
