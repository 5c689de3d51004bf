#pragma once
/// The inverse of a sparse matrix that changes slowly, in an order of elimination that is kept as long as no pivot is small.
/// Few orders are enough for most of a path: those that were left are tried before another one is looked for.
/// Where dozens of products follow each factorisation the inverse is cheaper than its factors: a product with it waits for
/// nothing.

#include <Eigen/Core>
#include <vector>

#include "solvers/lanes/column_kernels.hpp"
#include "solvers/lanes/elimination.hpp"
#include "solvers/lanes/instruction_set.hpp"

namespace gcs {

class SparseInverse {
 public:
  /// Of n × n matrices whose entries are 0 where those of `pattern` are.
  explicit SparseInverse(Eigen::MatrixXd pattern, InstructionSet set = widest_instruction_set());

  void compute(const Eigen::MatrixXd& matrix);
  /// 0 where the matrix is singular, and no product a number.
  int determinant_sign() const { return determinant_sign_; }
  /// The inverse times `right`, each of n numbers.
  void apply(const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> result);
  /// How many orders had to be found.
  int orders_found() const { return orders_found_; }

 private:
  /// Where an entry of the matrix is and what number it has.
  struct Place {
    int from = 0;
    int entry = 0;
  };
  /// An entry of L or U: that of this number over the pivot of a step.
  struct Term {
    int entry = 0;
    int pivot = 0;
  };
  struct Order {
    Elimination elimination;
    int sign = 1;  ///< of its permutations of rows and columns
    std::vector<Place> places;
    std::vector<ColumnStep> steps;  ///< with U, then with L
    std::vector<int> sources;
    std::vector<Term> terms;  ///< their factors
  };

  Order order_at(const Eigen::MatrixXd& matrix) const;
  void append_steps(Order& order) const;
  bool find_order(const Eigen::MatrixXd& matrix);
  bool factorise(const Order& order, const double* matrix, double most);
  void invert(Order& order);
  bool correct(const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> result);
  Eigen::Map<Eigen::VectorXd> inverse_entries() { return {inverse_.column(0), inverse_.stride() * n_}; }

  int n_;
  ColumnKernels kernels_;
  Eigen::MatrixXd pattern_;
  std::vector<Order> orders_;  ///< the last used first
  std::vector<double> entries_, inverse_pivots_, factors_;
  Eigen::MatrixXd matrix_;  ///< where it is ill-conditioned
  AlignedColumns inverse_;
  double matrix_norm_ = 0;
  bool is_well_conditioned_ = true;
  Eigen::VectorXd left_, correction_;
  int determinant_sign_ = 0;
  int orders_found_ = 0;
};

}  // namespace gcs
