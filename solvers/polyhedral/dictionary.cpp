#include "solvers/polyhedral/dictionary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr int no_label = -1;
constexpr int free_label = -2;

/// Coefficients are quotients of small integers, the minors of exponent differences, and liftings are at most
/// 1: what is below this, a million roundings beside 1, is 0 or in doubt.
constexpr double tolerance = 1e-10;

}  // namespace

Dictionary::Dictionary(int unknowns)
    : unknowns_(unknowns),
      columns_(unknowns),
      stride_(static_cast<std::size_t>(unknowns) + 1),
      table_(unknowns * stride_, 0.0),
      column_label_(static_cast<std::size_t>(unknowns), free_label),
      free_columns_(unknowns) {
  for (int v = 0; v < unknowns; ++v) row(v)[1 + v] = 1;
}

void Dictionary::add_restricted(const SparseForm& form, double weight, double* target) const {
  target[0] += weight * form.constant;
  for (const auto& [unknown, coefficient] : form.terms) {
    const double* const source = row(unknown);
    for (int j = 0; j <= columns_; ++j) target[j] += weight * coefficient * source[j];
  }
}

void Dictionary::append(const SparseForm& form, int label) {
  table_.resize(table_.size() + stride_, 0.0);
  row_label_.push_back(label);
  add_restricted(form, 1, row(rows() - 1));
}

void Dictionary::drop(int r) {
  const int last = rows() - 1;
  std::copy_n(row(last), stride_, row(r));
  row_label_[r - unknowns_] = row_label_.back();
  row_label_.pop_back();
  table_.resize(table_.size() - stride_);
}

bool Dictionary::constrain(const SparseForm& form, int label, SimplexWork& work) {
  append(form, label);
  const int r = rows() - 1;
  if (free_columns_ > 0 && replace_free_column(r, work)) return true;
  if (row(r)[0] >= 0) return true;
  ++work.linear_programs;
  if (drive_to_zero(r, work) == Move::reached) return true;
  if (row(r)[0] >= -tolerance) ++work.near_ties;
  return false;
}

bool Dictionary::replace_free_column(int r, SimplexWork& work) {
  int best = -1;
  double size = tolerance;
  for (int j = 0; j < columns_; ++j) {
    if (column_label_[j] != free_label || std::abs(row(r)[1 + j]) <= size) continue;
    best = j;
    size = std::abs(row(r)[1 + j]);
  }
  if (best < 0) return false;
  pivot(r, best, work);
  return true;
}

bool Dictionary::can_vanish(int label, SimplexWork& work) {
  if (std::find(column_label_.begin(), column_label_.end(), label) != column_label_.end()) return true;
  const auto found = std::find(row_label_.begin(), row_label_.end(), label);
  const int r = unknowns_ + static_cast<int>(found - row_label_.begin());
  ++work.linear_programs;
  if (drive_to_zero(r, work) == Move::reached) return true;
  if (row(r)[0] <= tolerance) ++work.near_ties;
  return false;
}

/// Moves slack r from its value towards 0 by the simplex method, as far as the other slacks allow. When it
/// arrives there it becomes a column.
Dictionary::Move Dictionary::drive_to_zero(int r, SimplexWork& work) {
  const double direction = row(r)[0] < 0 ? 1 : -1;
  while (true) {
    int column = -1;
    double slope = tolerance;
    for (int j = 0; j < columns_; ++j) {
      if (direction * row(r)[1 + j] <= slope) continue;
      column = j;
      slope = direction * row(r)[1 + j];
    }
    if (column < 0) return Move::blocked;
    const int blocking = blocking_row(r, column);
    pivot(blocking, column, work);
    if (blocking == r) return Move::reached;
    if (direction * row(r)[0] > 0) row(r)[0] = 0;
  }
}

/// The slack that vanishes first when the column grows: r itself or one that must not become negative.
int Dictionary::blocking_row(int r, int column) const {
  int first = r;
  double step = std::abs(row(r)[0] / row(r)[1 + column]);
  for (int i = unknowns_; i < rows(); ++i) {
    const double slope = -row(i)[1 + column];
    if (i == r || slope <= tolerance) continue;
    const double limit = std::max(row(i)[0], 0.0) / slope;
    if (limit >= step) continue;
    first = i;
    step = limit;
  }
  return first;
}

/// Exchanges slack r and a column. A free column is gone afterwards.
void Dictionary::pivot(int r, int column, SimplexWork& work) {
  ++work.pivots;
  double* const pivot_row = row(r);
  const double inverse = 1 / pivot_row[1 + column];
  for (int j = 0; j <= columns_; ++j) pivot_row[j] *= -inverse;
  pivot_row[1 + column] = inverse;
  for (int i = 0; i < rows(); ++i) {
    double* const target = row(i);
    const double factor = target[1 + column];
    if (i == r || factor == 0) continue;
    target[1 + column] = 0;
    for (int j = 0; j <= columns_; ++j) target[j] += factor * pivot_row[j];
  }
  std::swap(row_label_[r - unknowns_], column_label_[column]);
  if (row_label_[r - unknowns_] != free_label) return;
  --free_columns_;
  drop(r);
}

Dictionary Dictionary::face(int label) const {
  const int gone =
      static_cast<int>(std::find(column_label_.begin(), column_label_.end(), label) - column_label_.begin());
  Dictionary result(*this);
  result.columns_ = columns_ - 1;
  result.stride_ = stride_ - 1;
  result.column_label_.erase(result.column_label_.begin() + gone);
  for (int& l : result.column_label_) l = l == free_label ? free_label : no_label;
  result.row_label_.clear();
  int kept = 0;
  for (int r = 0; r < rows(); ++r) {
    const double* const source = row(r);
    double* const target = result.row(kept);
    std::copy_n(source, 1 + gone, target);
    std::copy(source + gone + 2, source + 1 + columns_, target + 1 + gone);
    if (r < unknowns_) {
      ++kept;
      continue;
    }
    const bool redundant = std::all_of(target, target + result.stride_, [](double x) { return x >= 0; });
    if (redundant) continue;
    result.row_label_.push_back(no_label);
    ++kept;
  }
  result.table_.resize(kept * result.stride_);
  return result;
}

}  // namespace gcs
