#include "solvers/numeric/biquadratic_pair.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/numeric/dense_factors.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Row i: (x + d)^i in powers of x.
Eigen::Matrix3d translation(double d) {
  Eigen::Matrix3d matrix;
  matrix << 1, 0, 0, d, 1, 0, d * d, 2 * d, 1;
  return matrix;
}

/// A rotation of P¹: x = (c·u + s)/(c − s·u).
struct Rotation {
  double c;
  double s;

  /// Row i: (c·u + s)^i (c − s·u)^(2−i) in powers of u.
  Eigen::Matrix3d of_squares() const {
    Eigen::Matrix3d matrix;
    matrix << c * c, -2 * c * s, s * s,  //
        c * s, c * c - s * s, -c * s,    //
        s * s, 2 * c * s, c * c;
    return matrix;
  }

  /// u
  Complex to(Complex x) const { return (c * x - s) / (s * x + c); }

  ProjectiveNumber back(Complex numerator, Complex denominator) const {
    const Complex x = c * numerator + s * denominator;
    const Complex w = c * denominator - s * numerator;
    const double norm = std::hypot(std::abs(x), std::abs(w));
    return {x / norm, w / norm};
  }
};

/// Any two angles will do for which no zero of the problem at hand becomes infinite.
const Rotation turn_x{std::cos(0.6180339887), std::sin(0.6180339887)};
const Rotation turn_y{std::cos(1.0986122887), std::sin(1.0986122887)};

/// Coefficient k of the Sylvester matrix in y, rows in falling powers of y.
Eigen::Matrix4d sylvester(const Biquadratic& p, const Biquadratic& q, int k) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i) {
    matrix(0, i) = matrix(1, i + 1) = p(k, 2 - i);
    matrix(2, i) = matrix(3, i + 1) = q(k, 2 - i);
  }
  return matrix;
}

/// Coefficients of a polynomial in y, lowest first, at x = u.
Eigen::Vector3cd at(const Biquadratic& p, Complex u) {
  return (p.row(0) + u * (p.row(1).cast<Complex>() + u * p.row(2).cast<Complex>())).transpose();
}

/// Both zeros of c0 + c1·y + c2·y², as (numerator, denominator), without cancellation and with zeros at
/// infinity.
std::array<std::array<Complex, 2>, 2> zeros(const Eigen::Vector3cd& c) {
  const Complex root = std::sqrt(c[1] * c[1] - 4.0 * c[0] * c[2]);
  const Complex sum = c[1] + (std::real(std::conj(c[1]) * root) >= 0 ? root : -root);
  return {{{-sum, 2.0 * c[2]}, {-2.0 * c[0], sum}}};
}

/// |c(y)| relative to the size of y.
double residual(const Eigen::Vector3cd& c, const std::array<Complex, 2>& y) {
  const auto [n, d] = y;
  return std::abs(c[0] * d * d + c[1] * n * d + c[2] * n * n) / (std::norm(n) + std::norm(d));
}

/// The y that go with an eigenvalue u. Precondition: p and q have norm 1.
std::vector<CommonZero> partners(const Biquadratic& p, const Biquadratic& q, Complex u) {
  const double also_a_zero = 1e-6 * (1 + std::norm(u));
  Eigen::Vector3cd larger = at(p, u);
  Eigen::Vector3cd smaller = at(q, u);
  if (smaller.norm() > larger.norm()) std::swap(larger, smaller);
  const auto ys = zeros(larger);
  const std::array<double, 2> misses{residual(smaller, ys[0]), residual(smaller, ys[1])};
  std::vector<CommonZero> found;
  for (int i = 0; i < 2; ++i) {
    const bool better = !(misses[i] > misses[1 - i]);
    if (better || misses[i] <= also_a_zero)
      found.push_back({turn_x.back(u, 1), turn_y.back(ys[i][0], ys[i][1])});
  }
  return found;
}

/// To the rounding of its entries.
bool is_singular(const Eigen::FullPivLU<Eigen::MatrixXd>& lu) {
  const Eigen::Vector4d pivots = lu.matrixLU().diagonal().cwiseAbs();
  return pivots.minCoeff() <= 64 * std::numeric_limits<double>::epsilon() * pivots.maxCoeff();
}

/// On both lines, with norm 1.
Biquadratic turned(const Biquadratic& p) {
  const Biquadratic result = turn_x.of_squares().transpose() * p * turn_y.of_squares();
  return result / result.norm();
}

}  // namespace

int degree(const Biquadratic& p) {
  int largest = -1;
  for (int i = 0; i < p.rows(); ++i)
    for (int j = 0; j < p.cols(); ++j)
      if (p(i, j) != 0) largest = std::max(largest, i + j);
  return largest;
}

Biquadratic shifted(const Biquadratic& p, double dx, double dy) {
  return translation(dx).transpose() * p * translation(dy);
}

CommonZeros common_zeros(const Biquadratic& p, const Biquadratic& q) {
  const Biquadratic f = turned(p), g = turned(q);
  CommonZeros result;
  const Eigen::FullPivLU<Eigen::MatrixXd> leading(sylvester(f, g, 2));
  result.common_factor =
      is_singular(leading) && is_singular(Eigen::FullPivLU<Eigen::MatrixXd>(sylvester(f, g, 0)));
  if (result.common_factor) return result;
  Matrix8 companion = Matrix8::Zero();
  companion.topRightCorner<4, 4>().setIdentity();
  companion.bottomLeftCorner<4, 4>() = -leading.solve(sylvester(f, g, 0));
  companion.bottomRightCorner<4, 4>() = -leading.solve(sylvester(f, g, 1));
  const Eigen::VectorXcd eigenvalues = eigenvalues_of(companion);
  for (int i = 0; i < 8; ++i) result.of_eigenvalue[i] = partners(f, g, eigenvalues[i]);
  return result;
}

CommonZeros common_zeros_over(const std::vector<Complex>& xs, const Biquadratic& p, const Biquadratic& q) {
  const Biquadratic f = turned(p), g = turned(q);
  CommonZeros result;
  for (std::size_t i = 0; i < xs.size(); ++i) result.of_eigenvalue[i] = partners(f, g, turn_x.to(xs[i]));
  return result;
}

}  // namespace gcs
