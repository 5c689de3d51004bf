#pragma once
/// Two equations in the squared diagonals X = |aa'|² and Y = |bb'|² of an octahedron: the Cayley–Menger
/// determinants of {a, a', b, b', c} and {a, a', b, b', c'} vanish. Each is of degree 2 in X and in Y.

#include "solvers/numeric/biquadratic_pair.hpp"
#include "solvers/octahedron/octahedron.hpp"

namespace gcs {

struct Diagonals {
  std::complex<double> x, y;
};

/// The equations in the products ξ = (a − c)·(a' − c) and η = (b − c)·(b' − c), in which they are short:
/// X = |a − c|² + |a' − c|² − 2ξ, and Y likewise.
class DiagonalEquations {
 public:
  DiagonalEquations(const SquaredLengths& lengths, const Octahedron& octahedron);

  /// Bézout's number: the product of the equations' degrees in X and Y together.
  int total_degree() const { return degree(first_) * degree(second_); }
  CommonZeros solve() const { return common_zeros(first_, second_); }
  /// The Y that go with given X, of which there are eight at most.
  CommonZeros solve_over(const std::vector<std::complex<double>>& squares) const;
  Diagonals diagonals(const CommonZero& zero) const {
    return {sum_x_ - 2.0 * zero.x.value(), sum_y_ - 2.0 * zero.y.value()};
  }

 private:
  double sum_x_, sum_y_;
  Biquadratic first_, second_;
};

}  // namespace gcs
