#include "solvers/lanes/sparse_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "solvers/lanes/lane_functions.hpp"

namespace gcs {
namespace {

/// An order is kept while no entry right of a pivot is larger than it by more: digits that a step of the elimination may
/// lose. Newton's method has them back, since it computes residuals anew.
constexpr double most_growth = 1e3;

/// Orders that are kept: what all of them cost where none is good is still less than looking for another one.
constexpr std::size_t most_orders = 8;

/// A product with the inverse errs by the roundoff times the condition number in all equations, where a solution by factors
/// errs in those alone that hardly change. Beyond this condition number it is corrected by what it leaves.
constexpr double well_conditioned = 1e4;
constexpr int most_corrections = 3;

/// Of the permutation that moves i to order[i].
int sign_of(const std::vector<int>& order) {
  std::vector<bool> is_done(order.size());
  int sign = 1;
  for (int first = 0; first < std::ssize(order); ++first)
    for (int i = first; !is_done[i]; i = order[i]) {
      is_done[i] = true;
      if (order[i] != first) sign = -sign;
    }
  return sign;
}

}  // namespace

SparseInverse::SparseInverse(Eigen::MatrixXd pattern, InstructionSet set)
    : n_(static_cast<int>(pattern.rows())),
      kernels_(lane_functions(set).columns),
      pattern_(std::move(pattern)),
      inverse_pivots_(static_cast<std::size_t>(n_)),
      inverse_(n_, n_),
      left_(n_),
      correction_(n_) {}

void SparseInverse::compute(const Eigen::MatrixXd& matrix) {
  if (!find_order(matrix)) {
    determinant_sign_ = 0;
    inverse_entries().setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  determinant_sign_ = orders_.front().sign;
  for (const double inverse : inverse_pivots_)
    if (inverse < 0) determinant_sign_ = -determinant_sign_;
  invert(orders_.front());
  kernels_.squares(inverse_.from(0), n_, correction_.data());
  is_well_conditioned_ = matrix_norm_ * std::sqrt(correction_.sum()) <= well_conditioned;
  if (!is_well_conditioned_) matrix_ = matrix;
}

/// Puts it first, with the matrix's factors in entries_. False where the matrix is singular.
bool SparseInverse::find_order(const Eigen::MatrixXd& matrix) {
  for (auto order = orders_.begin(); order != orders_.end(); ++order)
    if (factorise(*order, matrix.data(), most_growth)) {
      std::rotate(orders_.begin(), order, order + 1);
      return true;
    }
  if (orders_.size() == most_orders) orders_.pop_back();
  orders_.insert(orders_.begin(), order_at(matrix));
  ++orders_found_;
  return factorise(orders_.front(), matrix.data(), std::numeric_limits<double>::infinity());
}

void SparseInverse::apply(const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> result) {
  kernels_.combine(inverse_.from(0), n_, right.data(), result.data());
  if (is_well_conditioned_) return;
  for (int i = 0; i < most_corrections; ++i)
    if (!correct(right, result)) return;
}

/// False where what is left is the rounding of the product.
bool SparseInverse::correct(const Eigen::VectorXd& right, Eigen::Ref<Eigen::VectorXd> result) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  left_ = right;
  left_.noalias() -= matrix_ * result;
  if (left_.norm() <= rounding * matrix_norm_ * result.norm()) return false;
  kernels_.combine(inverse_.from(0), n_, left_.data(), correction_.data());
  result += correction_;
  return true;
}

SparseInverse::Order SparseInverse::order_at(const Eigen::MatrixXd& matrix) const {
  Order order{order_elimination(n_, pattern_.data(), matrix.data()), 1, {}, {}, {}, {}};
  order.sign = sign_of(order.elimination.equation) * sign_of(order.elimination.unknown);
  for (int i = 0; i < n_; ++i)
    for (int e = 0; e < n_; ++e)
      if (pattern_(e, i) != 0) order.places.push_back({i * n_ + e, order.elimination.entry(e, i)});
  append_steps(order);
  return order;
}

/// With B = L D U, unit diagonals of L and U, the columns of H = U⁻¹ follow from the first on, and those of
/// B⁻¹ = H D⁻¹ L⁻¹ from the last on. Each is kept where that of the inverse will be.
void SparseInverse::append_steps(Order& order) const {
  const auto& [rows, columns] = std::tie(order.elimination.equation, order.elimination.unknown);
  const auto add_step = [&](int target) {
    const auto first = static_cast<int>(order.terms.size());
    order.steps.push_back({target, first, first});
  };
  const auto add_term = [&](int row, int column, int source, int pivot) {
    const int entry = order.elimination.entry(row, column);
    if (entry < 0) return;
    order.sources.push_back(source);
    order.terms.push_back({entry, pivot});
    ++order.steps.back().last;
  };
  for (int k = 0; k < n_; ++k) {
    add_step(rows[k]);
    for (int i = 0; i < k; ++i) add_term(rows[i], columns[k], rows[i], i);
  }
  for (int k = n_; k-- > 0;) {
    add_step(rows[k]);
    for (int i = k + 1; i < n_; ++i) add_term(rows[i], columns[k], rows[i], k);
  }
}

/// False where a pivot is 0 or smaller beside its row than it may be.
bool SparseInverse::factorise(const Order& order, const double* matrix, double most) {
  const Elimination& elimination = order.elimination;
  entries_.assign(static_cast<std::size_t>(elimination.entries), 0.0);
  for (const Place& place : order.places) entries_[place.entry] = matrix[place.from];
  matrix_norm_ = Eigen::Map<const Eigen::VectorXd>(entries_.data(), std::ssize(entries_)).norm();
  for (int k = 0; k < n_; ++k) {
    const Elimination::Step &step = elimination.steps[k], &next = elimination.steps[k + 1];
    const double inverse = 1 / entries_[step.pivot];
    inverse_pivots_[k] = inverse;
    double largest = 0;
    for (int u = step.first_upper; u < next.first_upper; ++u)
      largest = std::max(largest, std::abs(entries_[elimination.upper[u].entry]));
    if (!std::isfinite(inverse) || !(largest * std::abs(inverse) <= most)) return false;
    for (int l = step.first_lower; l < next.first_lower; ++l) {
      const auto& [row, entry, targets] = elimination.lower[l];
      const double factor = entries_[entry] * inverse;
      const int* target = elimination.targets.data() + targets;
      for (int u = step.first_upper; u < next.first_upper; ++u, ++target)
        entries_[*target] -= factor * entries_[elimination.upper[u].entry];
    }
  }
  return true;
}

void SparseInverse::invert(Order& order) {
  factors_.resize(order.terms.size());
  for (std::size_t i = 0; i < factors_.size(); ++i)
    factors_[i] = entries_[order.terms[i].entry] * inverse_pivots_[order.terms[i].pivot];
  for (int k = 0; k < n_; ++k) order.steps[2 * n_ - 1 - k].scale = inverse_pivots_[k];
  inverse_entries().setZero();
  for (int k = 0; k < n_; ++k)
    inverse_.column(order.elimination.equation[k])[order.elimination.unknown[k]] = 1;
  kernels_.substitute(inverse_.column(0), inverse_.stride(), order.steps.data(), std::ssize(order.steps),
                      order.sources.data(), factors_.data());
}

}  // namespace gcs
