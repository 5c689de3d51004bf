#pragma once
/// Two equations in the diagonals X of a, a' and Y of b, b' of an octahedron: the Cayley–Menger determinants of
/// {a, a', b, b', c} and {a, a', b, b', c'} vanish. Each is of degree 2 in X and in Y.

#include "solvers/numeric/biquadratic_pair.hpp"
#include "solvers/octahedron/octahedron.hpp"

namespace gcs {

/// Entries of the pairs that are not given, as PairEntries has those that are.
struct Diagonals {
  std::complex<double> x, y;
};

/// The equations in the products ξ of a and a' and η of b and b' seen from the point c, in which they are short: of four
/// points ξ = (a − c)·(a' − c), X = |a − c|² + |a' − c|² − 2ξ, and Y likewise.
class DiagonalEquations {
 public:
  /// Precondition: c is a point.
  DiagonalEquations(const PairEntries& entries, const Octahedron& octahedron);

  /// Bézout's number: the product of the equations' degrees in X and Y together.
  int total_degree() const { return degree(first_) * degree(second_); }
  CommonZeros solve() const { return common_zeros(first_, second_); }
  /// The Y that go with given X, of which there are eight at most.
  CommonZeros solve_over(const std::vector<std::complex<double>>& diagonals) const;
  Diagonals diagonals(const CommonZero& zero) const {
    return {x_.diagonal(zero.x.value()), y_.diagonal(zero.y.value())};
  }

 private:
  /// A product is offset − X/2 where X is a squared distance, and offset + X otherwise.
  struct Product {
    double offset = 0;
    bool is_of_points = true;

    std::complex<double> diagonal(std::complex<double> product) const {
      return is_of_points ? 2.0 * (offset - product) : product - offset;
    }
    std::complex<double> of(std::complex<double> diagonal) const {
      return is_of_points ? offset - diagonal / 2.0 : offset + diagonal;
    }
  };

  Product x_, y_;
  Biquadratic first_, second_;
};

}  // namespace gcs
