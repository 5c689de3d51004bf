#pragma once
/// A polyhedron {α ∈ R^n : f_k(α) ≥ 0} with one of its vertices, as a simplex dictionary (V. Chvátal: Linear
/// Programming, 1983): α and the slacks f_k that are not 0 at the vertex are affine in the others, the
/// columns, which are 0 there. While it has no vertex some columns are free; no slack depends on those.

#include <cstdint>
#include <vector>

namespace gcs {

/// constant + Σ coefficient · α_unknown.
struct SparseForm {
  struct Term {
    int unknown = 0;
    double coefficient = 0;
  };
  double constant = 0;
  std::vector<Term> terms;
};

/// Deterministic counts of work.
struct SimplexWork {
  std::int64_t linear_programs = 0;
  std::int64_t pivots = 0;
  std::int64_t near_ties = 0;  ///< decisions by less than rounding allows to trust: the answer is in doubt

  SimplexWork& operator+=(const SimplexWork& other) {
    linear_programs += other.linear_programs;
    pivots += other.pivots;
    near_ties += other.near_ties;
    return *this;
  }
};

class Dictionary {
 public:
  /// All of R^unknowns.
  explicit Dictionary(int unknowns);

  /// Adds form ≥ 0 as the slack `label` ≥ 0. False when nothing is left; the dictionary is useless then.
  bool constrain(const SparseForm& form, int label, SimplexWork& work);
  /// Whether the slack vanishes somewhere. Moves to such a vertex if so.
  bool can_vanish(int label, SimplexWork& work);
  /// The face where the slack vanishes, of one dimension less; what remains has no labels. Precondition:
  /// can_vanish said so of this slack, and nothing was done since.
  Dictionary face(int label) const;

  int dimension() const { return columns_; }
  /// Adds weight · form, as an affine function of the columns, to target: the constant, then a coefficient
  /// for each of the dimension() columns.
  void add_restricted(const SparseForm& form, double weight, double* target) const;

 private:
  enum class Move { reached, blocked };

  double* row(int r) { return table_.data() + static_cast<std::size_t>(r) * stride_; }
  const double* row(int r) const { return table_.data() + static_cast<std::size_t>(r) * stride_; }
  int rows() const { return unknowns_ + static_cast<int>(row_label_.size()); }
  void append(const SparseForm& form, int label);
  void drop(int r);
  bool replace_free_column(int r, SimplexWork& work);
  Move drive_to_zero(int r, SimplexWork& work);
  int blocking_row(int r, int column) const;
  void pivot(int r, int column, SimplexWork& work);

  int unknowns_;
  int columns_;
  std::size_t stride_;         ///< of the table: the constant, then the columns
  std::vector<double> table_;  ///< rows of α, then of the slacks
  std::vector<int> row_label_;
  std::vector<int> column_label_;
  int free_columns_;
};

}  // namespace gcs
