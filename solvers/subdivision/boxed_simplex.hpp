#pragma once
/// A small dense linear program, of which every variable has two bounds, by the simplex method: the variables
/// z_j ∈ [−1, 1] and, for each row of a matrix A, s_e = (A z)_e ∈ [low_e, high_e]. (Chvátal, Linear
/// programming, 1983, chapter 8: bounded variables; chapter 10: the dual simplex method.)
///
/// It is in doubles and proves nothing: what it gives are multipliers, from which anybody can derive a bound
/// that holds (linear_narrowing.hpp). A library is no better here: the programs have some ten to fifty
/// columns, a box asks for twice as many objectives of the same constraints, and each takes a few exchanges in
/// the table that the last one left, a microsecond each, where a call of a library that is made for sparse
/// programs takes longer than that.

#include <Eigen/Core>
#include <vector>

namespace gcs {

class BoxedSimplex {
 public:
  /// Entries of A should be of order 1.
  BoxedSimplex(const Eigen::MatrixXd& rows, Eigen::VectorXd low, Eigen::VectorXd high);

  enum class End { feasible, infeasible, gave_up };
  /// Looks for a point that keeps all bounds. To be called first.
  End find_point();
  /// Multipliers y of the rows for which Σ y_e s_e − (Aᵀy)·z = 0 has no solution within the bounds but for
  /// rounding. Precondition: find_point() said infeasible.
  Eigen::VectorXd contradiction() const;

  /// Minimises ±z_j from the present point on. Returns multipliers y: z_j = Σ y_e s_e + (e_j − Aᵀy)·z, where
  /// every term at its bound gives the optimum. Precondition: find_point() said feasible.
  Eigen::VectorXd minimise(int j, double sign);
  /// The present value of z_j.
  double value(int j) const { return value_of_[static_cast<std::size_t>(j)]; }

  std::int64_t pivots() const { return pivots_; }

 private:
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  double low(int variable) const { return low_[variable]; }
  double high(int variable) const { return high_[variable]; }
  void pivot(Eigen::Index basic, Eigen::Index nonbasic);
  void update_values();
  Eigen::VectorXd multipliers(const Eigen::VectorXd& of_nonbasic) const;

  int columns_;
  RowMatrix table_;  ///< basic variables as combinations of the others
  Eigen::VectorXd cost_;
  Eigen::VectorXd low_, high_;  ///< of all variables: z first, then s
  std::vector<int> basic_, nonbasic_;
  std::vector<double> value_of_;
  Eigen::Index contradicting_ = -1;
  std::int64_t pivots_ = 0;
};

}  // namespace gcs
