#include "solvers/tangents/tangent_algebra.hpp"

#include <Eigen/LU>
#include <cmath>

#include "solvers/numeric/dense_factors.hpp"
#include "solvers/tangents/tangent_relations.hpp"

namespace gcs {
namespace {

/// Relative to the largest pivot: below it a relation is a combination of the others. The syzygy's pivot is
/// of the order of the rounding; the others of well-placed spheres are above 1e-4.
constexpr double dependent = 1e-13;

/// Numbers of a monomial's products in the next weight. Monomials of u have numbers below `own`, those of τ
/// follow from `next` on.
int product_number(int monomial, int own, int next, int variable) {
  const bool has_tau = monomial >= own;
  const TernaryExponents e = exponents(has_tau ? monomial - own : monomial);
  const int product = monomial_number(e.x + (variable == 0 ? 1 : 0), e.y + (variable == 1 ? 1 : 0));
  return product + (has_tau ? next : 0);
}

/// 0: x, 1: y, 2: g.
int product_in_weight_5(int monomial_of_weight_4, int variable) {
  return product_number(monomial_of_weight_4, monomial_count(4), monomial_count(5), variable);
}

}  // namespace

std::optional<TangentAlgebra> TangentAlgebra::of(const TangentEquations& equations) {
  TangentAlgebra algebra;
  if (!algebra.reduce_weight_5(equations) || !algebra.choose_basis() || !algebra.complete_rows())
    return std::nullopt;
  return algebra;
}

/// The null space of the relations, by elimination with complete pivoting: the monomials without a pivot are
/// a first basis.
bool TangentAlgebra::reduce_weight_5(const TangentEquations& equations) {
  constexpr int rows = relation_count(5), rank = weight_5 - tangent_count;
  static_assert(weight_5 == weight_count(5) && weight_4 == weight_count(4));
  Eigen::Matrix<double, rows, weight_5> relations;
  fill_relations(equations, 5, relations);
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(relations);
  if (!(std::abs(lu.matrixLU()(rank - 1, rank - 1)) > dependent * lu.maxPivot())) return false;
  Eigen::Matrix<double, rank, tangent_count> bound = -lu.matrixLU().topRightCorner<rank, tangent_count>();
  lu.matrixLU().topLeftCorner<rank, rank>().triangularView<Eigen::Upper>().solveInPlace(bound);
  for (int i = 0; i < weight_5; ++i) {
    const int monomial = lu.permutationQ().indices()[i];
    if (i < rank)
      normal_.row(monomial) = bound.row(i);
    else
      normal_.row(monomial) = RowVector::Unit(i - rank);
  }
  return true;
}

/// Weight 4 times g is a hyperplane of weight 5: the basis is turned so that this is spanned by all elements
/// but the last.
bool TangentAlgebra::choose_basis() {
  Eigen::Matrix<double, tangent_count, weight_4> from_below;
  for (int m = 0; m < weight_4; ++m) from_below.col(m) = normal_.row(product_in_weight_5(m, 2)).transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(from_below);
  const AlgebraMatrix turn = orthogonal_factor(qr);
  normal_ = (normal_ * turn).eval();
  for (int i = 0; i < below; ++i) chosen_[i] = qr.colsPermutation().indices()[i];
  triangle_ = qr.matrixR().topLeftCorner<below, below>().transpose();
  const double smallest = std::abs(triangle_(below - 1, below - 1));
  return smallest > dependent * std::abs(triangle_(0, 0));
}

/// Rows of the chosen monomials' images turned into rows of the first basis elements' images.
TangentAlgebra::Part TangentAlgebra::reduced(const Part& rows) const {
  return triangle_.triangularView<Eigen::Lower>().solve(rows);
}

/// x·(y·a) = y·(x·a) for the a of weight 4: with X = [X1 t] and Y = [Y1 s] the known rows and ξ, η the
/// missing ones, X1 Y + t η = Y1 X + s ξ.
bool TangentAlgebra::complete_rows() {
  Part x, y;
  for (int i = 0; i < below; ++i) {
    x.row(i) = normal_.row(product_in_weight_5(chosen_[i], 0));
    y.row(i) = normal_.row(product_in_weight_5(chosen_[i], 1));
  }
  x = reduced(x);
  y = reduced(y);
  const Part excess = x.leftCols<below>() * y - y.leftCols<below>() * x;
  Eigen::Matrix<double, below, 2> last;
  last << y.col(below), -x.col(below);
  const Eigen::Matrix2d gram = last.transpose() * last;
  if (!(gram.determinant() > dependent * gram.squaredNorm())) return false;
  const Eigen::Matrix<double, 2, tangent_count> missing = gram.inverse() * (last.transpose() * excess);
  times_x_ << x, missing.row(0);
  times_y_ << y, missing.row(1);
  return true;
}

TangentAlgebra::RowVector TangentAlgebra::times(const RowVector& element, int variable) const {
  if (variable == 2) return element;
  return element * (variable == 0 ? times_x_ : times_y_);
}

/// τ·m as an element, for a monomial m of weight 4: m is a variable times one of weight 3.
TangentAlgebra::RowVector TangentAlgebra::tau_times(int m, const TangentEquations& equations) const {
  const bool has_tau = m >= monomial_count(4);
  const TernaryExponents e = exponents(has_tau ? m - monomial_count(4) : m);
  const int variable = e.x > 0 ? 0 : e.y > 0 ? 1 : 2;
  const int rest = monomial_number(e.x - (variable == 0 ? 1 : 0), e.y - (variable == 1 ? 1 : 0));
  if (!has_tau) return times(normal_.row(monomial_count(5) + rest), variable);
  Form<5> squared = Form<5>::Zero();
  add_product(equations.rho(), rest, 1, squared);
  return times(squared.transpose() * normal_.topRows<monomial_count(5)>(), variable);
}

AlgebraMatrix TangentAlgebra::times_tau(const TangentEquations& equations) const {
  Part rows;
  for (int i = 0; i < below; ++i) rows.row(i) = tau_times(chosen_[i], equations);
  rows = reduced(rows);
  // τ commutes with x and y: the last row follows from the others.
  const auto last_x = times_x_.topRightCorner<below, 1>(), last_y = times_y_.topRightCorner<below, 1>();
  const Part excess_x = rows * times_x_ - times_x_.topLeftCorner<below, below>() * rows;
  const Part excess_y = rows * times_y_ - times_y_.topLeftCorner<below, below>() * rows;
  AlgebraMatrix result;
  result << rows, (last_x.transpose() * excess_x + last_y.transpose() * excess_y) /
                      (last_x.squaredNorm() + last_y.squaredNorm());
  return result;
}

/// From τ·m³ and m³, m the largest of x, y and g = 1.
template <class Scalar>
Scalar TangentAlgebra::tau(const AlgebraVector<Scalar>& w, Scalar x, Scalar y) const {
  const double size_x = std::abs(x), size_y = std::abs(y);
  int i = 0, j = 0;
  if (size_x > 1 && size_x >= size_y)
    i = 3;
  else if (size_y > 1)
    j = 3;
  const int cube = monomial_number(i, j);
  const auto value = [&](int monomial) {
    return (normal_.row(monomial).template cast<Scalar>() * w).value();
  };
  return value(monomial_count(5) + cube) / value(cube);
}

template double TangentAlgebra::tau(const AlgebraVector<double>&, double, double) const;
template std::complex<double> TangentAlgebra::tau(const AlgebraVector<std::complex<double>>&,
                                                  std::complex<double>, std::complex<double>) const;

}  // namespace gcs
