#include "solvers/octahedron/diagonal_zeros.hpp"

#include "solvers/octahedron/exact_elimination.hpp"

namespace gcs {
namespace {

/// The roots of the polynomial in X, each as often as it is one.
DiagonalZeros exact_zeros(const Scene& scene, const Octahedron& octahedron,
                          const DiagonalEquations& equations) {
  const OctahedronPolynomials polynomials = eliminated(scene, octahedron);
  EliminationFacts facts{polynomials.height.degree(), 0, polynomials.real_solutions()};
  if (!facts.real_solutions) facts.real_solutions = separated_real_solutions(scene, octahedron);
  if (polynomials.height.is_zero()) {
    CommonZeros none;
    none.common_factor = true;
    return {none, facts};
  }
  facts.distinct_real_roots = polynomials.height.real_root_count();
  std::vector<std::complex<double>> diagonals;
  for (const PolynomialRoot& root : polynomials.diagonal.roots())
    diagonals.insert(diagonals.end(), static_cast<std::size_t>(root.multiplicity), root.value);
  return {equations.solve_over(diagonals), facts};
}

}  // namespace

DiagonalZeros diagonal_zeros(const Scene& scene, const Octahedron& octahedron,
                             const DiagonalEquations& equations, DiagonalMethod method) {
  if (method == DiagonalMethod::univariate) return exact_zeros(scene, octahedron, equations);
  return {equations.solve(), std::nullopt};
}

}  // namespace gcs
