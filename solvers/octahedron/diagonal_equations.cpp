#include "solvers/octahedron/diagonal_equations.hpp"

#include <Eigen/LU>
#include <array>
#include <bit>
#include <vector>

namespace gcs {
namespace {

/// Of two elements as vectors of R^{4,1} (pair_entries.hpp), less their parts along a plane.
double product_across(const PairEntries& d, int plane, int p, int q) {
  const double product = d.is_plane(p) || d.is_plane(q) ? d(p, q) : -d(p, q) / 2;
  return product - d(p, plane) * d(q, plane);
}

/// Of two elements seen from a third one. Of a diagonal, which is 0 here, it is the offset.
double product_from(const PairEntries& d, int apex, int p, int q) {
  return d.is_plane(apex) ? product_across(d, apex, p, q) : doubled_product(d, apex, p, q) / 2;
}

/// The Gram determinant of the four vectors from the apex to a, a', b, b', which is the Cayley–Menger
/// determinant up to a factor: [P, Q; Qᵀ, R] with ξ in P and η in R is
///   det P · det R − tr(adj P · Q · adj R · Qᵀ) + det² Q.
Biquadratic gram_determinant(const PairEntries& d, const Octahedron& o, int apex) {
  const auto [a, a2] = o.pair[0];
  const auto [b, b2] = o.pair[1];
  const auto product = [&](int p, int q) { return product_from(d, apex, p, q); };
  const double aa = product(a, a);
  const double a2a2 = product(a2, a2);
  const double bb = product(b, b);
  const double b2b2 = product(b2, b2);
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

/// The determinant of a matrix as a polynomial in ξ, which is added in rows 0 and 1, and η, in rows 2 and 3: where k of
/// the two places of each are chosen, the minor without their rows and columns times −1 if k > 0.
Biquadratic expanded(const Eigen::MatrixXd& matrix) {
  constexpr std::array<std::array<int, 2>, 4> places{{{0, 1}, {1, 0}, {2, 3}, {3, 2}}};
  Biquadratic sum = Biquadratic::Zero();
  for (unsigned chosen = 0; chosen < 16; ++chosen) {
    std::vector<int> rows, columns;
    for (int i = 0; i < matrix.rows(); ++i) {
      const auto is_left = [&](std::size_t side) {
        for (std::size_t place = 0; place < places.size(); ++place)
          if ((chosen >> place & 1U) != 0 && places[place][side] == i) return false;
        return true;
      };
      if (is_left(0)) rows.push_back(i);
      if (is_left(1)) columns.push_back(i);
    }
    const int of_x = std::popcount(chosen & 3U), of_y = std::popcount(chosen >> 2);
    const double sign = (of_x > 0) == (of_y > 0) ? 1 : -1;
    sum(of_x, of_y) += sign * matrix(rows, columns).determinant();
  }
  return sum;
}

/// The Cayley–Menger determinant of a, a', b, b' and a plane, in the products across it: its pivot is taken, and the
/// row of the vector e is left, 1 for points and 0 for planes.
Biquadratic bordered_determinant(const PairEntries& d, const Octahedron& o, int plane) {
  const std::array<int, 4> elements{o.pair[0][0], o.pair[0][1], o.pair[1][0], o.pair[1][1]};
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(5, 5);
  for (int i = 0; i < 4; ++i) {
    const int p = elements[static_cast<std::size_t>(i)];
    matrix(i, 4) = matrix(4, i) = d.is_plane(p) ? 0 : 1;
    for (int j = 0; j < 4; ++j)
      if (i / 2 != j / 2 || i == j)
        matrix(i, j) = product_across(d, plane, p, elements[static_cast<std::size_t>(j)]);
  }
  return expanded(matrix);
}

}  // namespace

DiagonalEquations::DiagonalEquations(const PairEntries& entries, const Octahedron& octahedron) {
  const auto [c, c2] = octahedron.pair[2];
  const auto product = [&](std::size_t pair, int apex) {
    const auto [p, q] = octahedron.pair[pair];
    return Product{product_from(entries, apex, p, q), !entries.is_plane(p) && !entries.is_plane(q)};
  };
  x_ = product(0, c);
  y_ = product(1, c);
  first_ = gram_determinant(entries, octahedron, c);
  const Biquadratic second = entries.is_plane(c2) ? bordered_determinant(entries, octahedron, c2)
                                                  : gram_determinant(entries, octahedron, c2);
  second_ = shifted(second, product(0, c2).offset - x_.offset, product(1, c2).offset - y_.offset);
}

CommonZeros DiagonalEquations::solve_over(const std::vector<std::complex<double>>& diagonals) const {
  std::vector<std::complex<double>> products;
  for (const std::complex<double>& x : diagonals) products.push_back(x_.of(x));
  return common_zeros_over(products, first_, second_);
}

}  // namespace gcs
