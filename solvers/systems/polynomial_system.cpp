#include "solvers/systems/polynomial_system.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace gcs {
namespace {

/// Of the first `unknowns` unknowns.
Exponents monomial_of(const RationalPolynomial::Term& term, int unknowns) {
  return {term.exponents.begin(), term.exponents.begin() + unknowns};
}

struct HighestDegreeFirst {
  bool operator()(const Exponents& a, const Exponents& b) const {
    const int of_a = std::accumulate(a.begin(), a.end(), 0), of_b = std::accumulate(b.begin(), b.end(), 0);
    return of_a != of_b ? of_a > of_b : a > b;
  }
};

/// An equation by its monomials; no coefficient is 0.
using Row = std::map<Exponents, Rational, HighestDegreeFirst>;

Row row_of(const RationalPolynomial& equation, int unknowns) {
  Row row;
  for (const RationalPolynomial::Term& term : equation.terms())
    row.emplace(monomial_of(term, unknowns), term.coefficient);
  return row;
}

RationalPolynomial polynomial_of(const Row& row) {
  RationalPolynomial sum = Rational(0);
  for (const auto& [exponents, coefficient] : row) {
    RationalPolynomial product = coefficient;
    for (int i = 0; i < static_cast<int>(exponents.size()); ++i)
      for (int k = 0; k < exponents[static_cast<std::size_t>(i)]; ++k)
        product = product * RationalPolynomial::variable(i);
    sum = sum + product;
  }
  return sum;
}

/// Takes the monomial out of `row` by a multiple of `pivot`, whose coefficient of it is 1.
void eliminate(const Exponents& monomial, const Row& pivot, Row& row) {
  const auto found = row.find(monomial);
  if (found == row.end()) return;
  const Rational factor = found->second;
  for (const auto& [exponents, coefficient] : pivot) {
    Rational& entry = row[exponents];
    entry = entry - factor * coefficient;
    if (entry.is_zero()) row.erase(exponents);
  }
}

void divide_by_first(Row& row) {
  const Rational first = row.begin()->second;
  for (auto& [exponents, coefficient] : row) coefficient = coefficient / first;
}

}  // namespace

int PolynomialSystem::terms() const {
  std::size_t count = 0;
  for (const RationalPolynomial& equation : equations) count += equation.terms().size();
  return static_cast<int>(count);
}

Natural PolynomialSystem::total_degree() const {
  Natural product = 1;
  for (const RationalPolynomial& equation : equations)
    product = product * Natural(static_cast<std::uint64_t>(equation.total_degree()));
  return product;
}

Supports supports_of(const PolynomialSystem& system) {
  Supports supports;
  for (const RationalPolynomial& equation : system.equations) {
    Support& support = supports.emplace_back();
    for (const RationalPolynomial::Term& term : equation.terms())
      support.push_back(monomial_of(term, system.unknowns));
  }
  return supports;
}

std::vector<ComplexVectorX> coefficients_of(const PolynomialSystem& system) {
  std::vector<ComplexVectorX> all;
  for (const RationalPolynomial& equation : system.equations) {
    ComplexVectorX& coefficients = all.emplace_back();
    for (const RationalPolynomial::Term& term : equation.terms())
      coefficients.emplace_back(term.coefficient.approximate());
    const double size = largest(coefficients);
    for (std::complex<double>& coefficient : coefficients) coefficient /= size;
  }
  return all;
}

PolynomialSystem echelon_form(const PolynomialSystem& system) {
  std::vector<Row> left, pivots;
  for (const RationalPolynomial& equation : system.equations)
    left.push_back(row_of(equation, system.unknowns));
  const auto leads_later = [](const Row& a, const Row& b) {
    if (a.empty() || b.empty()) return !a.empty() && b.empty();
    return HighestDegreeFirst()(a.begin()->first, b.begin()->first);
  };
  while (!left.empty()) {
    std::iter_swap(left.begin(), std::min_element(left.begin(), left.end(), leads_later));
    Row pivot = std::move(left.front());
    left.erase(left.begin());
    if (pivot.empty()) continue;
    divide_by_first(pivot);
    const Exponents monomial = pivot.begin()->first;
    for (std::vector<Row>* rows : {&left, &pivots})
      for (Row& row : *rows) eliminate(monomial, pivot, row);
    pivots.push_back(std::move(pivot));
  }
  PolynomialSystem result{system.unknowns, {}};
  for (const Row& row : pivots) result.equations.push_back(polynomial_of(row));
  return result;
}

RationalPolynomial squared(const RationalPolynomial& polynomial) { return polynomial * polynomial; }

}  // namespace gcs
