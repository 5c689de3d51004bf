#include "solvers/homotopies/start_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

/// Of Σ (u − v)² − A, relative to the sum of what it is made of: a solution to the last digit leaves some
/// 1e-15, and one with an error in any digit that matters to the tracker far more.
constexpr double residual_limit = 1e-10;

std::string sum(const std::vector<std::string>& terms) {
  return terms.empty() ? "0" : fmt::format("{}", fmt::join(terms, " + "));
}

/// "(x0-x3)^2 + (x1-0.5)^2": all but the right-hand side.
std::string equation_text(const SquareSystem& system, int e) {
  std::vector<std::string> terms;
  for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
    const Difference& difference = system.differences[d];
    const std::string other = difference.subtrahend < 0 ? fmt::format("{}", difference.constant)
                                                        : fmt::format("x{}", difference.subtrahend);
    terms.push_back(fmt::format("(x{}-{})^2", difference.minuend, other));
  }
  for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l) {
    const LinearTerm& term = system.linear[l];
    terms.push_back(
        fmt::format("({}+{}i)*x{}", term.coefficient.real(), term.coefficient.imag(), term.unknown));
  }
  if (system.given[e] != 0) terms.push_back(fmt::format("{}", system.given[e]));
  return sum(terms);
}

/// "2*x0*x3 + x1": all but the value, and its own sign where it has one.
std::string equation_text(const GeneralEquations& equations, int e) {
  const MonomialSystem& system = equations.system;
  std::vector<std::string> terms;
  for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
    if (j == equations.value_monomial[e]) continue;
    std::string term = fmt::format("{}", equations.coefficients[j].real());
    for (const int unknown : {system.monomials[j].u, system.monomials[j].v})
      if (unknown >= 0) term += fmt::format("*x{}", unknown);
    terms.push_back(term);
  }
  return sum(terms);
}

/// One for each equation.
template <class Equations>
std::vector<std::string> equation_texts(const Equations& equations, int count) {
  std::vector<std::string> texts;
  for (int e = 0; e < count; ++e) texts.push_back(equation_text(equations, e));
  return texts;
}

/// The largest residual of an equation, relative to its terms; infinite where one is no finite number.
double relative_residual(const SquareSystem& system, const ComplexVectorX& x, const ComplexVectorX& squares) {
  const ComplexVectorX found = squares_at(system, x);
  double largest_residual = 0;
  for (int e = 0; e < system.equations(); ++e) {
    double size = std::abs(squares[e]);
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      size += std::norm(x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]));
    }
    const double residual = std::abs(found[e] - squares[e]) / size;
    if (!std::isfinite(residual)) return std::numeric_limits<double>::infinity();
    largest_residual = std::max(largest_residual, residual);
  }
  return largest_residual;
}

}  // namespace

StartFamily start_family(const SquareSystem& system, SignMasks signs) {
  return {equation_texts(system, system.equations()), system.unknowns, system.equations(), std::move(signs),
          [&system](const ComplexVectorX& x, const ComplexVectorX& squares) {
            return relative_residual(system, x, squares);
          }};
}

StartFamily start_family(const GeneralEquations& equations) {
  const auto free = std::ranges::count_if(equations.value_monomial, [](int j) { return j >= 0; });
  return {equation_texts(equations, equations.system.equations()), equations.system.unknowns,
          static_cast<int>(free), equations.signs,
          [&equations](const ComplexVectorX& x, const ComplexVectorX& values) {
            const EquationValues here = values_at(equations.system, with_values(equations, values), x);
            double largest_residual = 0;
            for (std::size_t e = 0; e < here.value.size(); ++e) {
              const double residual = std::abs(here.value[e]) / std::max(here.size[e], 1e-300);
              if (!std::isfinite(residual)) return std::numeric_limits<double>::infinity();
              largest_residual = std::max(largest_residual, residual);
            }
            return largest_residual;
          }};
}

std::optional<StartDefect> find_defect(const StartFamily& family, const GenericSolutions& generic) {
  std::mt19937_64 random(1);  // for keys of a set, which change no answer
  SolutionSet known(family.signs, random);
  for (std::size_t i = 0; i < generic.solutions.size(); ++i) {
    const int number = static_cast<int>(i);
    const ComplexVectorX& x = generic.solutions[i];
    if (family.residual(x, generic.squares) > residual_limit)
      return StartDefect{number, "this is no solution for the generic squared lengths"};
    if (const int twin = known.insert(x, 0); twin != number)
      return StartDefect{number, "this is solution " + std::to_string(twin) + " again, up to reflection"};
  }
  return std::nullopt;
}

}  // namespace gcs
