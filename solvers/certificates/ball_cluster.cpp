#include "solvers/certificates/ball_cluster.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace gcs {
namespace {

/// Solutions of a cluster of corank 1: as many turns as the endgame of paths makes around their ends.
constexpr int most_in_line = 8;
/// So that they are 64 at most.
constexpr int most_corank = 6;

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

std::optional<BallMatrix> inverse_of(const BallMatrix& matrix, slong bits) {
  BallMatrix inverse(matrix.rows(), matrix.columns());
  return acb_mat_inv(inverse.get(), matrix.get(), bits) != 0 ? std::optional(inverse) : std::nullopt;
}

BallMatrix product(const BallMatrix& a, const BallMatrix& b, slong bits) {
  BallMatrix result(a.rows(), b.columns());
  acb_mat_mul(result.get(), a.get(), b.get(), bits);
  return result;
}

/// A bound in doubles as one of real numbers: more than what 4000 roundings, one after the other, take from a sum of products,
/// and what falls below the least of them.
template <class Bound>
Eigen::VectorXd rounded_up(const Bound& bound) {
  return ((bound * (1 + 0x1p-40)).array() + std::numeric_limits<double>::min()).matrix();
}

/// At least β^k, also where that is below the least double.
double upper_power(double beta, std::size_t k) {
  return std::max(std::pow(beta, static_cast<double>(k)), std::numeric_limits<double>::min());
}

/// Of the coordinates b.
using Exponents = std::vector<int>;

int degree_of(const Exponents& monomial) { return std::accumulate(monomial.begin(), monomial.end(), 0); }

std::vector<Exponents> monomials_of(int degree, Eigen::Index variables) {
  if (variables == 1) return {{degree}};
  std::vector<Exponents> result;
  for (int last = 0; last <= degree; ++last)
    for (Exponents& monomial : monomials_of(degree - last, variables - 1)) {
      monomial.push_back(last);
      result.push_back(std::move(monomial));
    }
  return result;
}

/// f in the coordinates (a, b), by the moduli of its coefficients: a polynomial in b alone, one in b times a, and products of
/// two of a.
class Expansion {
 public:
  /// `highest`: degree of the curve.
  Expansion(const BallKrawczyk& system, const BallMatrix& x, int corank, int highest)
      : system_(system),
        unknowns_(system.unknowns()),
        corank_(corank),
        regular_(unknowns_ - corank),
        bits_(system.bits()) {
    const BallMatrix jacobian = system.jacobian(x);
    if (!choose_coordinates(middles(jacobian))) return;
    if (corank > 1 && !separate_squares()) return;
    const auto to_coordinates = inverse_of(directions_, bits_);
    if (!to_coordinates || !inverse_of(combine_, bits_)) return;
    to_coordinates_ = moduli(*to_coordinates);
    constant_ = product(combine_, system.value(x), bits_);
    linear_ = product(combine_, product(jacobian, directions_, bits_), bits_);
    find_curve(highest);
    set_bounds(highest);
    is_valid_ = true;
  }

  /// Whether the coordinates could be chosen.
  bool is_valid() const { return is_valid_; }

  /// Where the derivative of this order of f₂ vanishes, relative to x, by a step of Newton's method in b along the
  /// curve. Precondition: r = 1.
  BallMatrix step_to_middle(int order) const {
    Ball b, power;
    acb_div(b, own_(0, order), own_(0, order + 1), bits_);
    acb_div_si(b, b, -(order + 1), bits_);
    acb_get_mid(b, b);
    acb_one(power);
    BallMatrix z(unknowns_, 1);
    for (const auto& [monomial, term] : curve_) {
      for (slong i = 0; i < unknowns_; ++i) acb_addmul(z(i, 0), term(i, 0), power, bits_);
      acb_mul(power, power, b, bits_);
    }
    return product(directions_, z, bits_);
  }

  /// Bounds of a and b within a box about x.
  struct Held {
    Eigen::VectorXd a;
    double b = 0;
  };

  /// Within `reach` of x, as it follows from V₁(a + A(b)) + V₂b. Precondition: is_valid().
  Held held(const Eigen::VectorXd& reach) const {
    const Eigen::VectorXd moved = rounded_up(to_coordinates_ * reach);
    Held bounds;
    bounds.b = moved.tail(corank_).maxCoeff();
    bounds.a = rounded_up(moved + sum(curve_sizes_, bounds.b)).head(regular_);
    return bounds;
  }

  /// The polydisc that the theorem proves with forms of this degree and this β, a power of two, and that holds these points.
  std::optional<BallCluster> cluster(int degree, double beta, const Held* held = nullptr) const {
    if (!is_valid_) return std::nullopt;
    const double leading = std::pow(beta, degree);
    const Eigen::VectorXd of_b = sum(alone_, beta);
    // What b alone leaves of f₁, and as much again for a itself; that of the forms where it is nothing.
    Eigen::VectorXd size = 2 * rounded_up(of_b).head(regular_).cwiseMax(leading);
    if (held != nullptr) {
      if (!(held->b <= beta)) return std::nullopt;
      size = size.cwiseMax(held->a);
    }
    Eigen::VectorXd with_a = Eigen::VectorXd::Zero(unknowns_);
    for (std::size_t k = 0; k < with_a_.size(); ++k) with_a += upper_power(beta, k) * (with_a_[k] * size);
    for (Eigen::Index j = 0; j < regular_; ++j)
      with_a += size[j] * (squares_[static_cast<std::size_t>(j)] * size);
    if (!(rounded_up(of_b + with_a).head(regular_).array() < size.array()).all()) return std::nullopt;
    Eigen::VectorXd left = (of_b + with_a).tail(corank_);
    for (slong power = 0; power < own_.columns(); ++power)
      for (slong k = 0; k < corank_ && power != degree; ++k)
        left[k] += upper_power(beta, static_cast<std::size_t>(power)) * magnitude(own_(k, power));
    left = rounded_up(left);
    for (slong k = 0; k < corank_; ++k)
      if (!(left[k] / leading * (1 + 0x1p-40) < least_magnitude(own_(k, degree)))) return std::nullopt;
    Eigen::VectorXd reach = sum(curve_sizes_, beta);
    reach.head(regular_) += size;
    reach = rounded_up(directions_in_doubles_.cwiseAbs() * reach);
    if (!reach.allFinite()) return std::nullopt;
    const auto solutions = static_cast<int>(std::lround(std::pow(degree, corank_)));
    return BallCluster{solutions, {reach.begin(), reach.end()}};
  }

 private:
  /// False where more directions than these are singular.
  bool choose_coordinates(const Eigen::MatrixXcd& jacobian) {
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    directions_in_doubles_ = svd.matrixV();
    combine_in_doubles_ = svd.matrixU().adjoint();
    for (Eigen::Index i = 0; i < regular_; ++i) combine_in_doubles_.row(i) /= svd.singularValues()[i];
    return enclose_coordinates();
  }

  bool enclose_coordinates() {
    if (!combine_in_doubles_.allFinite() || !directions_in_doubles_.allFinite()) return false;
    combine_ = balls(combine_in_doubles_);
    directions_ = balls(directions_in_doubles_);
    return true;
  }

  /// Other b and f₂, so that f₂ begins with the squares of b one by one, if any do: as Wᵀ Q_k W are diagonal for all of its
  /// quadratic forms Q_k, the columns of W are eigenvectors of Q'⁻¹Q'' for any two combinations of these.
  bool separate_squares() {
    std::vector<Eigen::MatrixXcd> forms(static_cast<std::size_t>(corank_),
                                        Eigen::MatrixXcd(corank_, corank_));
    for (Eigen::Index i = 0; i < corank_; ++i) {
      BallMatrix b(unknowns_, 1);
      acb_one(b(regular_ + i, 0));
      const Eigen::MatrixXcd bend = middles(slope_along(b)).bottomRightCorner(corank_, corank_);
      for (std::size_t k = 0; k < forms.size(); ++k) forms[k].row(i) = bend.row(static_cast<Eigen::Index>(k));
    }
    Eigen::MatrixXcd one = Eigen::MatrixXcd::Zero(corank_, corank_), other = one;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      one += std::polar(1.0, 2.4 * static_cast<double>(k)) * forms[k];  // in no step with anything
      other += std::polar(1.0, 1.1 * static_cast<double>(k)) * forms[k];
    }
    const Eigen::MatrixXcd quotient = other.partialPivLu().solve(one);
    if (!quotient.allFinite()) return false;
    const Eigen::MatrixXcd turn = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(quotient).eigenvectors();
    Eigen::MatrixXcd squares(corank_, corank_);
    for (std::size_t k = 0; k < forms.size(); ++k)
      squares.row(static_cast<Eigen::Index>(k)) = (turn.transpose() * forms[k] * turn).diagonal();
    directions_in_doubles_.rightCols(corank_) = (directions_in_doubles_.rightCols(corank_) * turn).eval();
    combine_in_doubles_.bottomRows(corank_) =
        squares.partialPivLu().solve(combine_in_doubles_.bottomRows(corank_)).eval();
    return enclose_coordinates();
  }

  /// (A(b), b): by A f₁ vanishes up to the highest degree, to twice the digits of doubles.
  void find_curve(int highest) {
    // What is left of f₁ is that of the pass before times what is left of the unit matrix.
    constexpr int passes = 2;
    for (int degree = 0; degree <= highest; ++degree)
      for (const Exponents& monomial : monomials_of(degree, corank_)) {
        BallMatrix z(unknowns_, 1);
        for (slong j = 0; j < corank_ && degree == 1; ++j)
          acb_set_si(z(regular_ + j, 0), monomial[static_cast<std::size_t>(j)]);
        set_curve(monomial, z);
      }
    for (int pass = 0; pass < passes; ++pass)
      for (int degree = 0; degree <= highest; ++degree)
        for (const Exponents& monomial : monomials_of(degree, corank_)) {
          BallMatrix z = curve_.at(monomial);
          const BallMatrix left = coefficient(monomial);
          for (slong i = 0; i < regular_; ++i) {
            acb_sub(z(i, 0), z(i, 0), left(i, 0), bits_);
            acb_get_mid(z(i, 0), z(i, 0));
          }
          set_curve(monomial, z);
        }
  }

  void set_curve(const Exponents& monomial, const BallMatrix& z) {
    curve_.insert_or_assign(monomial, z);
    slopes_.insert_or_assign(monomial, slope_along(z));
  }

  /// Of f along the curve.
  BallMatrix coefficient(const Exponents& monomial) const {
    BallMatrix sum(unknowns_, 1);
    if (degree_of(monomial) == 0) acb_mat_set(sum.get(), constant_.get());
    if (const auto own = curve_.find(monomial); own != curve_.end())
      acb_mat_add(sum.get(), sum.get(), product(linear_, own->second, bits_).get(), bits_);
    for (const auto& [factor, slope] : slopes_) {
      Exponents other = monomial;
      for (std::size_t i = 0; i < other.size(); ++i) other[i] -= factor[i];
      if (const auto found = curve_.find(other); found != curve_.end())
        acb_mat_add(sum.get(), sum.get(), product(slope, found->second, bits_).get(), bits_);
    }
    return sum;
  }

  /// What the quadratic part of f makes of `z` and another vector is its product with that.
  BallMatrix slope_along(const BallMatrix& z) const {
    BallMatrix bend = system_.jacobian(product(directions_, z, bits_));
    acb_mat_sub(bend.get(), bend.get(), at_zero_.get(), bits_);
    acb_mat_scalar_mul_2exp_si(bend.get(), bend.get(), -1);
    return product(combine_, product(bend, directions_, bits_), bits_);
  }

  void set_bounds(int highest) {
    for (int degree = 0; degree <= 2 * highest; ++degree) {
      alone_.emplace_back(Eigen::VectorXd::Zero(unknowns_));
      for (const Exponents& monomial : monomials_of(degree, corank_)) {
        BallMatrix of_b = coefficient(monomial);
        for (slong k = 0; k < corank_; ++k)
          if (monomial[static_cast<std::size_t>(k)] == degree)
            acb_swap(own_(k, degree), of_b(regular_ + k, 0));
        alone_.back() += moduli(of_b);
      }
    }
    BallMatrix defect = linear_;
    for (slong i = 0; i < regular_; ++i) acb_sub_si(defect(i, i), defect(i, i), 1, bits_);
    with_a_.assign(static_cast<std::size_t>(highest) + 1, Eigen::MatrixXd::Zero(unknowns_, regular_));
    curve_sizes_.assign(with_a_.size(), Eigen::VectorXd::Zero(unknowns_));
    with_a_[0] = moduli(defect).leftCols(regular_);
    for (const auto& [monomial, slope] : slopes_) {
      const auto degree = static_cast<std::size_t>(degree_of(monomial));
      with_a_[degree] += 2 * moduli(slope).leftCols(regular_);
      curve_sizes_[degree] += moduli(curve_.at(monomial));
    }
    BallMatrix unit(unknowns_, 1);
    for (slong j = 0; j < regular_; ++j) {
      acb_one(unit(j, 0));
      squares_.push_back(moduli(slope_along(unit)).leftCols(regular_));
      acb_zero(unit(j, 0));
    }
  }

  /// Σ terms[k] β^k
  static Eigen::VectorXd sum(const std::vector<Eigen::VectorXd>& terms, double beta) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(terms.front().size());
    for (std::size_t k = 0; k < terms.size(); ++k) result += upper_power(beta, k) * terms[k];
    return result;
  }

  const BallKrawczyk& system_;
  Eigen::Index unknowns_, corank_, regular_;
  slong bits_;
  BallMatrix at_zero_ = system_.jacobian(BallMatrix(unknowns_, 1));  ///< the Jacobian
  Eigen::MatrixXcd directions_in_doubles_, combine_in_doubles_;
  BallMatrix directions_{unknowns_, unknowns_}, combine_{unknowns_, unknowns_};
  Eigen::MatrixXd to_coordinates_;  ///< moduli of the inverse of the directions
  BallMatrix constant_{unknowns_, 1}, linear_{unknowns_, unknowns_};
  std::map<Exponents, BallMatrix> curve_, slopes_;    ///< (A(b), b), and slope_along() of its terms
  std::vector<Eigen::VectorXd> alone_, curve_sizes_;  ///< by degree in b, without own_
  std::vector<Eigen::MatrixXd> with_a_;               ///< by degree in b, beside the a of f₁ itself
  std::vector<Eigen::MatrixXd> squares_;              ///< entry j, row k, column i: of a_i a_j in equation k
  BallMatrix own_{corank_, 2 * most_in_line};         ///< row k, column d: of b_k^d in f₂'s entry k
  bool is_valid_ = false;
};

/// How many singular values may be those of directions that the Jacobian nearly takes to zero: below an eighth of the others.
std::vector<int> possible_coranks(const BallKrawczyk& system, const BallMatrix& x) {
  const Eigen::VectorXd sizes =
      Eigen::JacobiSVD<Eigen::MatrixXcd>(middles(system.jacobian(x))).singularValues();
  const auto unknowns = static_cast<int>(sizes.size());
  std::vector<int> result;
  for (int corank = 1; corank <= std::min(most_corank, unknowns); ++corank)
    if (corank == unknowns || 8 * sizes[unknowns - corank] < sizes[unknowns - corank - 1])
      result.push_back(corank);
  return result;
}

bool is_finite(const BallMatrix& matrix) { return acb_mat_is_finite(matrix.get()) != 0; }

/// Of the smallest β and r that the theorem proves; that holds all points within `reach` of x.
std::optional<BallCluster> smallest_cluster(const BallKrawczyk& system, const BallMatrix& x,
                                            const Eigen::VectorXd* reach) {
  // Unknowns are of order 1. Half of the digits of doubles are left to the point at least; below, twice as
  // many digits as a point in doubles can have are of no use.
  constexpr int largest = -4, smallest = -104;
  for (const int corank : possible_coranks(system, x)) {
    const int most = corank == 1 ? most_in_line : 2;
    const Expansion expansion(system, x, corank, most - 1);
    if (!expansion.is_valid()) continue;
    const auto held = reach != nullptr ? std::optional(expansion.held(*reach)) : std::nullopt;
    for (int exponent = smallest; exponent <= largest; ++exponent)
      for (int degree = 2; degree <= most; ++degree)
        if (auto cluster = expansion.cluster(degree, std::ldexp(1.0, exponent), held ? &*held : nullptr))
          return cluster;
  }
  return std::nullopt;
}

}  // namespace

std::optional<BallMatrix> meeting_point(const BallKrawczyk& system, const std::vector<Complex>& x,
                                        int solutions) {
  constexpr int steps = 6, digits = 200;  // each step doubles the digits of the point
  if (solutions < 2 || solutions > most_in_line) return std::nullopt;
  BallMatrix at = BallKrawczyk::vector(x);
  for (int step = 0; is_finite(at); ++step) {
    const Expansion expansion(system, at, 1, solutions - 1);
    if (!expansion.is_valid()) return std::nullopt;
    if (step == steps)
      return expansion.cluster(solutions, std::ldexp(1.0, -digits / solutions)) ? std::optional(at)
                                                                                : std::nullopt;
    acb_mat_add(at.get(), at.get(), expansion.step_to_middle(solutions - 1).get(), system.bits());
    acb_mat_get_mid(at.get(), at.get());
  }
  return std::nullopt;
}

std::optional<BallCluster> prove_cluster(const BallKrawczyk& system, const std::vector<Complex>& x) {
  return smallest_cluster(system, BallKrawczyk::vector(x), nullptr);
}

int solutions_about(const BallKrawczyk& system, const BallMatrix& x, const std::vector<double>& reach) {
  const Eigen::VectorXd box = Eigen::VectorXd::Map(reach.data(), static_cast<Eigen::Index>(reach.size()));
  const std::optional<BallCluster> cluster = smallest_cluster(system, x, &box);
  return cluster ? cluster->solutions : 0;
}

}  // namespace gcs
