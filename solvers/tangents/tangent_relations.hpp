#pragma once
/// The relations that f1 and f2 give between the monomials of one weight, modulo f3.

#include <Eigen/Core>
#include <algorithm>

#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

/// Monomials of a weight modulo f3: those of u, then τ times those of the weight less 2.
constexpr int weight_count(int weight) {
  return monomial_count(weight) + (weight >= 2 ? monomial_count(weight - 2) : 0);
}
constexpr int relation_count(int weight) { return weight_count(weight - 2) + weight_count(weight - 3); }

/// Row r: a multiple of f1 or f2, columns as monomials. `relations` is
/// relation_count(weight) × weight_count(weight).
template <class Matrix>
void fill_relations(const TangentEquations& equations, int weight, Matrix& relations) {
  relations.setZero();
  const int tau_begin = monomial_count(weight);
  int r = 0;
  const auto row = [&](int from) { return relations.row(r).segment(from, relations.cols() - from); };
  // Every equation is scaled to the size 1.
  const double scale_1 = 1 / std::max(std::abs(equations.h()), equations.kappa().cwiseAbs().maxCoeff());
  const double scale_2 =
      1 / std::max(equations.l().cwiseAbs().maxCoeff(), equations.s().cwiseAbs().maxCoeff());
  const double h = scale_1 * equations.h();
  for (int m = 0; m < monomial_count(weight - 2); ++m, ++r) {
    relations(r, tau_begin + m) = h;
    add_product(equations.kappa(), m, -scale_1, row(0));
  }
  for (int m = 0; m < monomial_count(weight - 4); ++m, ++r) {  // τ²h = hρ
    add_product(equations.rho(), m, h, row(0));
    add_product(equations.kappa(), m, -scale_1, row(tau_begin));
  }
  for (int m = 0; m < monomial_count(weight - 3); ++m, ++r) {
    add_product(equations.l(), m, scale_2, row(tau_begin));
    add_product(equations.s(), m, scale_2, row(0));
  }
  for (int m = 0; m < monomial_count(weight - 5); ++m, ++r) {  // τ²l = lρ
    add_product(form_product<1, 4>(equations.l(), equations.rho()), m, scale_2, row(0));
    add_product(equations.s(), m, scale_2, row(tau_begin));
  }
}

}  // namespace gcs
