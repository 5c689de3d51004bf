#include "solvers/certificates/ball_cluster.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace gcs {
namespace {

/// More than what rounding takes from a sum of a few hundred moduli.
constexpr double round_up = 1 + 0x1p-40;

using Complex = std::complex<double>;

BallMatrix balls(const Eigen::MatrixXcd& numbers) {
  BallMatrix result(numbers.rows(), numbers.cols());
  for (Eigen::Index i = 0; i < numbers.rows(); ++i)
    for (Eigen::Index j = 0; j < numbers.cols(); ++j)
      acb_set_d_d(result(i, j), numbers(i, j).real(), numbers(i, j).imag());
  return result;
}

Eigen::MatrixXcd middles(const BallMatrix& matrix) {
  Eigen::MatrixXcd result(matrix.rows(), matrix.columns());
  for (slong i = 0; i < matrix.rows(); ++i)
    for (slong j = 0; j < matrix.columns(); ++j) result(i, j) = rounded_midpoint(matrix(i, j));
  return result;
}

Eigen::MatrixXd moduli(const BallMatrix& matrix) {
  Eigen::MatrixXd result(matrix.rows(), matrix.columns());
  for (slong i = 0; i < matrix.rows(); ++i)
    for (slong j = 0; j < matrix.columns(); ++j) result(i, j) = magnitude(matrix(i, j));
  return result;
}

bool is_invertible(const BallMatrix& matrix, slong bits) {
  BallMatrix inverse(matrix.rows(), matrix.columns());
  return acb_mat_inv(inverse.get(), matrix.get(), bits) != 0;
}

BallMatrix product(const BallMatrix& a, const BallMatrix& b, slong bits) {
  BallMatrix result(a.rows(), b.columns());
  acb_mat_mul(result.get(), a.get(), b.get(), bits);
  return result;
}

/// The quadratic forms q_k(b) = c_k0 b₁² + c_k1 b₁b₂ + c_k2 b₂², of one variable where there is one form.
class KernelForms {
 public:
  KernelForms(int corank, slong bits) : bits_(bits), coefficients_(corank, corank == 1 ? 1 : 3) {}

  BallMatrix& coefficients() { return coefficients_; }

  /// Whether some |q_k(b)| is above bound_k wherever the largest |b_j| is 1.
  bool exceed(const Eigen::VectorXd& bound) const {
    if (coefficients_.rows() == 1) return least_magnitude(coefficients_(0, 0)) > bound[0];
    return exceed(bound, false, 0, 1, 0) && exceed(bound, true, 0, 1, 0);
  }

 private:
  /// On the square of the side 2·half about z: b = (1, z), or (z, 1) where swapped.
  bool exceed(const Eigen::VectorXd& bound, bool swapped, Complex z, double half, int depth) const {
    constexpr int deepest = 10;
    Ball at, value;
    acb_set_d_d(at, z.real(), z.imag());
    for (const arb_ptr part : {acb_realref(static_cast<acb_ptr>(at)), acb_imagref(static_cast<acb_ptr>(at))})
      mag_set_d(arb_radref(part), half);
    for (slong k = 0; k < 2; ++k) {
      acb_mul(value, coefficients_(k, swapped ? 0 : 2), at, bits_);
      acb_add(value, value, coefficients_(k, 1), bits_);
      acb_mul(value, value, at, bits_);
      acb_add(value, value, coefficients_(k, swapped ? 2 : 0), bits_);
      if (least_magnitude(value) > bound[k]) return true;
    }
    if (depth == deepest) return false;
    for (const double re : {-half / 2, half / 2})
      for (const double im : {-half / 2, half / 2})
        if (!exceed(bound, swapped, z + Complex(re, im), half / 2, depth + 1)) return false;
    return true;
  }

  slong bits_;
  BallMatrix coefficients_;
};

/// f in the coordinates (a, b), by the moduli of its coefficients.
class Expansion {
 public:
  Expansion(const BallKrawczyk& system, const std::vector<Complex>& x, int corank)
      : unknowns_(system.unknowns()),
        regular_(unknowns_ - corank),
        bits_(system.bits()),
        forms_(corank, bits_) {
    const BallMatrix at = BallKrawczyk::vector(x), jacobian = system.jacobian(at);
    if (!choose_coordinates(middles(jacobian))) return;
    const BallMatrix combine = balls(combine_), directions = balls(directions_);
    if (!is_invertible(combine, bits_) || !is_invertible(directions, bits_)) return;
    constant_ = moduli(product(combine, system.value(at), bits_));
    BallMatrix linear = product(combine, product(jacobian, directions, bits_), bits_);
    for (slong i = 0; i < regular_; ++i) acb_sub_si(linear(i, i), linear(i, i), 1, bits_);
    linear_ = moduli(linear);
    set_quadratic(system, combine, directions);
    is_valid_ = true;
  }

  /// The polydisc that the theorem proves with this β.
  std::optional<BallCluster> cluster(double beta) const {
    if (!is_valid_) return std::nullopt;
    const Eigen::Index corank = unknowns_ - regular_;
    Eigen::VectorXd size = Eigen::VectorXd::Zero(unknowns_);
    size.tail(corank).setConstant(beta);
    // What b alone moves a by, and as much again for a itself; β² where that is nothing.
    size.head(regular_) = 2 * bounds(size, true).head(regular_).cwiseMax(beta * beta);
    const Eigen::VectorXd moved = bounds(size, true) * round_up;
    if (!(moved.head(regular_).array() < size.head(regular_).array()).all()) return std::nullopt;
    const Eigen::VectorXd left = bounds(size, false).tail(corank) * round_up;
    if (!forms_.exceed(left / (beta * beta) * round_up)) return std::nullopt;
    BallCluster cluster{1 << corank, {}};
    const Eigen::VectorXd reach = directions_.cwiseAbs() * size * round_up;
    cluster.radius.assign(reach.begin(), reach.end());
    return cluster;
  }

 private:
  /// False where more directions than these are singular.
  bool choose_coordinates(const Eigen::MatrixXcd& jacobian) {
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    directions_ = svd.matrixV();
    combine_ = svd.matrixU().adjoint();
    for (Eigen::Index i = 0; i < regular_; ++i) combine_.row(i) /= svd.singularValues()[i];
    return combine_.allFinite();
  }

  void set_quadratic(const BallKrawczyk& system, const BallMatrix& combine, const BallMatrix& directions) {
    const BallMatrix at_zero = system.jacobian(BallMatrix(unknowns_, 1));
    BallMatrix direction(unknowns_, 1);
    for (slong j = 0; j < unknowns_; ++j) {
      for (slong i = 0; i < unknowns_; ++i) acb_set(direction(i, 0), directions(i, j));
      BallMatrix bend = system.jacobian(direction);
      acb_mat_sub(bend.get(), bend.get(), at_zero.get(), bits_);
      acb_mat_scalar_mul_2exp_si(bend.get(), bend.get(), -1);
      const BallMatrix column = product(combine, product(bend, directions, bits_), bits_);
      quadratic_.push_back(moduli(column));
      if (j >= regular_) set_forms(j - regular_, column);
    }
  }

  /// `column`: what the products of b_j with all coordinates have as factors.
  void set_forms(slong j, const BallMatrix& column) {
    BallMatrix& coefficients = forms_.coefficients();
    for (slong k = 0; k < coefficients.rows(); ++k)
      for (slong i = 0; i < coefficients.rows(); ++i)
        acb_add(coefficients(k, i + j), coefficients(k, i + j), column(regular_ + k, regular_ + i), bits_);
  }

  /// Of f − (a, 0) where the coordinates are at most as large as `size`; the products of two b are left out
  /// where not `with_forms`.
  Eigen::VectorXd bounds(const Eigen::VectorXd& size, bool with_forms) const {
    Eigen::VectorXd result = constant_ + linear_ * size;
    for (Eigen::Index j = 0; j < unknowns_; ++j) {
      const Eigen::Index with = with_forms || j < regular_ ? unknowns_ : regular_;
      result += size[j] * (quadratic_[static_cast<std::size_t>(j)].leftCols(with) * size.head(with));
    }
    return result;
  }

  Eigen::Index unknowns_, regular_;
  slong bits_;
  Eigen::MatrixXcd directions_, combine_;
  Eigen::VectorXd constant_;
  Eigen::MatrixXd linear_;
  std::vector<Eigen::MatrixXd> quadratic_;  ///< entry j, row k, column i: of z_i z_j in equation k
  KernelForms forms_;
  bool is_valid_ = false;
};

}  // namespace

std::optional<BallCluster> prove_cluster(const BallKrawczyk& system, const std::vector<Complex>& x) {
  // Unknowns are of order 1. Half of the digits of doubles are left to the point at least; below, twice as
  // many digits as a point in doubles can have are of no use.
  constexpr int largest = -4, smallest = -104;
  for (int corank = 1; corank <= std::min(2, system.unknowns()); ++corank) {
    const Expansion expansion(system, x, corank);
    for (int exponent = smallest; exponent <= largest; ++exponent)
      if (auto cluster = expansion.cluster(std::ldexp(1.0, exponent))) return cluster;
  }
  return std::nullopt;
}

}  // namespace gcs
