#include "solvers/octahedron/diagonal_equations.hpp"

namespace gcs {
namespace {

/// |p − apex|² + |p' − apex|² of a pair.
double sum_of_squares(const SquaredLengths& d, const std::array<int, 2>& pair, int apex) {
  return d(pair[0], apex) + d(pair[1], apex);
}

/// The Gram determinant of the four vectors from the apex to a, a', b, b', which is the Cayley–Menger
/// determinant up to a factor: [P, Q; Qᵀ, R] with ξ in P and η in R is
///   det P · det R − tr(adj P · Q · adj R · Qᵀ) + det² Q.
Biquadratic gram_determinant(const SquaredLengths& d, const Octahedron& o, int apex) {
  const auto [a, a2] = o.pair[0];
  const auto [b, b2] = o.pair[1];
  const auto product = [&](int p, int q) { return (d(p, apex) + d(q, apex) - d(p, q)) / 2; };
  const double aa = d(a, apex);
  const double a2a2 = d(a2, apex);
  const double bb = d(b, apex);
  const double b2b2 = d(b2, apex);
  const double p = product(a, b);
  const double q = product(a, b2);
  const double r = product(a2, b);
  const double s = product(a2, b2);
  const double determinant = p * s - q * r;
  Biquadratic c = Biquadratic::Zero();
  c(2, 2) = 1;
  c(2, 0) = -bb * b2b2;
  c(0, 2) = -aa * a2a2;
  c(1, 1) = -2 * (p * s + q * r);
  c(1, 0) = 2 * (p * r * b2b2 + q * s * bb);
  c(0, 1) = 2 * (a2a2 * p * q + aa * r * s);
  c(0, 0) = aa * a2a2 * bb * b2b2 - a2a2 * (p * p * b2b2 + q * q * bb) - aa * (r * r * b2b2 + s * s * bb) +
            determinant * determinant;
  return c;
}

}  // namespace

DiagonalEquations::DiagonalEquations(const SquaredLengths& lengths, const Octahedron& octahedron) {
  const auto [c, c2] = octahedron.pair[2];
  sum_x_ = sum_of_squares(lengths, octahedron.pair[0], c);
  sum_y_ = sum_of_squares(lengths, octahedron.pair[1], c);
  const double dx = (sum_of_squares(lengths, octahedron.pair[0], c2) - sum_x_) / 2;
  const double dy = (sum_of_squares(lengths, octahedron.pair[1], c2) - sum_y_) / 2;
  first_ = gram_determinant(lengths, octahedron, c);
  second_ = shifted(gram_determinant(lengths, octahedron, c2), dx, dy);
}

CommonZeros DiagonalEquations::solve_over(const std::vector<std::complex<double>>& squares) const {
  std::vector<std::complex<double>> products;
  for (const std::complex<double>& x : squares) products.push_back((sum_x_ - x) / 2.0);
  return common_zeros_over(products, first_, second_);
}

}  // namespace gcs
