#pragma once
/// The common zeros of the three tangent equations as joint eigenvalues.
///
/// Modulo f3 every polynomial is A(u) + τB(u). In weight 5 there are 21 + 10 monomials, and f1 and f2 times
/// all monomials that fit give 20 relations of rank 19 (one syzygy): 12 monomials remain, as many as there
/// are solutions. With (x, y, g) = u and g = 1 these are a basis of the algebra of functions on the
/// solutions, provided that none has g = 0, and what takes weight 4 into weight 5 are the matrices of
/// multiplication by x and y but for one row, which follows from their commuting. (Auzinger, Stetter 1988;
/// Cox, Little, O'Shea, Using Algebraic Geometry, chapter 2, section 4.)

#include <Eigen/Core>
#include <optional>

#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

inline constexpr int tangent_count = equation_weights[0] * equation_weights[1] * equation_weights[2] / 2;

using AlgebraMatrix = Eigen::Matrix<double, tangent_count, tangent_count>;
template <class Scalar>
using AlgebraVector = Eigen::Matrix<Scalar, tangent_count, 1>;

/// Row i of times_x is x times basis element i; a joint eigenvector holds the values of the basis at a
/// solution and its eigenvalues are x and y there.
class TangentAlgebra {
 public:
  /// Nothing where weight 5 keeps more than 12 monomials to rounding, or a solution has g = 0.
  static std::optional<TangentAlgebra> of(const TangentEquations& equations);

  const AlgebraMatrix& times_x() const { return times_x_; }
  const AlgebraMatrix& times_y() const { return times_y_; }
  AlgebraMatrix times_tau(const TangentEquations& equations) const;

  /// τ at the solution whose eigenvector is `w` and where x and y are these.
  template <class Scalar>
  Scalar tau(const AlgebraVector<Scalar>& w, Scalar x, Scalar y) const;

 private:
  static constexpr int weight_4 = 15 + 6;          ///< monomials of u, then τ times those of weight 2
  static constexpr int weight_5 = 21 + 10;         ///< likewise
  static constexpr int below = tangent_count - 1;  ///< dimension of weight 4

  using Normals = Eigen::Matrix<double, weight_5, tangent_count>;
  using Part = Eigen::Matrix<double, below, tangent_count>;
  using RowVector = Eigen::Matrix<double, 1, tangent_count>;

  TangentAlgebra() = default;
  bool reduce_weight_5(const TangentEquations& equations);
  bool choose_basis();
  bool complete_rows();
  Part reduced(const Part& rows) const;
  RowVector tau_times(int monomial_of_weight_4, const TangentEquations& equations) const;
  RowVector times(const RowVector& element, int variable) const;

  Normals normal_;                                ///< row: a monomial of weight 5 in the basis
  std::array<int, below> chosen_{};               ///< monomials of weight 4 that are independent
  Eigen::Matrix<double, below, below> triangle_;  ///< they are triangle_ · (first basis elements)
  AlgebraMatrix times_x_;
  AlgebraMatrix times_y_;
};

}  // namespace gcs
