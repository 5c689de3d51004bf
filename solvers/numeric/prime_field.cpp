#include "solvers/numeric/prime_field.hpp"

#include <flint/nmod_mat.h>

#include <utility>

namespace gcs {
namespace {

/// The matrix in FLINT's form.
class FlintMatrix {
 public:
  FlintMatrix(const ResidueMatrix& rows, std::size_t columns) {
    nmod_mat_init(value_, static_cast<slong>(rows.size()), static_cast<slong>(columns), Residue::modulus);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < columns; ++j) nmod_mat_entry(value_, i, j) = rows[i][j].value();
  }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;
  ~FlintMatrix() { nmod_mat_clear(value_); }

  nmod_mat_struct* get() { return value_; }
  Residue at(std::size_t row, std::size_t column) const {
    return Residue(nmod_mat_entry(value_, row, column));
  }

 private:
  nmod_mat_t value_;
};

// Elimination is our own: rows of rigidity matrices have few entries, and of a graph of 1900 points the rank takes
// a thirtieth of the time that FLINT's dense elimination does.

/// row −= factor · pivot_row from column `from` on.
void subtract_multiple(ResidueVector& row, const ResidueVector& pivot_row, Residue factor, std::size_t from) {
  for (std::size_t j = from; j < row.size(); ++j) {
    if (!pivot_row[j].is_zero()) row[j] -= factor * pivot_row[j];
  }
}

/// Moves a row with a non-zero entry in `column` to place `target` and scales that entry to 1;
/// false: there is none.
bool bring_pivot(ResidueMatrix& matrix, std::size_t target, std::size_t column) {
  for (std::size_t i = target; i < matrix.size(); ++i) {
    if (matrix[i][column].is_zero()) continue;
    std::swap(matrix[i], matrix[target]);
    const Residue inverse = matrix[target][column].inverse();
    for (Residue& entry : matrix[target]) entry = inverse * entry;
    return true;
  }
  return false;
}

/// Brings the matrix to row echelon form with unit pivots and returns the pivots' columns. `reduced`: the
/// entries above the pivots become zero too.
std::vector<std::size_t> eliminate(ResidueMatrix& matrix, bool reduced) {
  std::vector<std::size_t> pivot_columns;
  const std::size_t columns = matrix.empty() ? 0 : matrix.front().size();
  for (std::size_t column = 0; column < columns && pivot_columns.size() < matrix.size(); ++column) {
    const std::size_t pivot = pivot_columns.size();
    if (!bring_pivot(matrix, pivot, column)) continue;
    for (std::size_t i = reduced ? 0 : pivot + 1; i < matrix.size(); ++i) {
      const Residue factor = matrix[i][column];
      if (i != pivot && !factor.is_zero()) subtract_multiple(matrix[i], matrix[pivot], factor, column);
    }
    pivot_columns.push_back(column);
  }
  return pivot_columns;
}

}  // namespace

Residue3 operator+(const Residue3& a, const Residue3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Residue3 operator-(const Residue3& a, const Residue3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Residue3 operator*(Residue factor, const Residue3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Residue dot(const Residue3& a, const Residue3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Residue3 cross(const Residue3& a, const Residue3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Residue dot(const ResidueVector& a, const ResidueVector& b) {
  Residue sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

int rank(ResidueMatrix matrix) { return static_cast<int>(eliminate(matrix, false).size()); }

ResidueMatrix null_space(ResidueMatrix matrix, int columns) {
  const std::vector<std::size_t> pivots = eliminate(matrix, true);
  ResidueMatrix basis;
  std::size_t next_pivot = 0;
  for (std::size_t column = 0; column < static_cast<std::size_t>(columns); ++column) {
    if (next_pivot < pivots.size() && pivots[next_pivot] == column) {
      ++next_pivot;
      continue;
    }
    ResidueVector vector(static_cast<std::size_t>(columns));
    vector[column] = Residue(1);
    for (std::size_t i = 0; i < pivots.size(); ++i) vector[pivots[i]] = -matrix[i][column];
    basis.push_back(std::move(vector));
  }
  return basis;
}

std::optional<ScaledSolution> solve(const ResidueMatrix& augmented) {
  const std::size_t n = augmented.size();
  FlintMatrix matrix(augmented, n);
  const Residue determinant(nmod_mat_det(matrix.get()));
  if (determinant.is_zero()) return std::nullopt;
  FlintMatrix right({n, ResidueVector(1)}, 1), solution({n, ResidueVector(1)}, 1);
  for (std::size_t i = 0; i < n; ++i) nmod_mat_entry(right.get(), i, 0) = augmented[i][n].value();
  nmod_mat_solve(solution.get(), matrix.get(), right.get());
  ScaledSolution result{determinant, {}};
  for (std::size_t i = 0; i < n; ++i) result.numerators.push_back(solution.at(i, 0) * determinant);
  return result;
}

ResidueMatrix transposed(const ResidueMatrix& matrix, int columns) {
  ResidueMatrix result(static_cast<std::size_t>(columns), ResidueVector(matrix.size()));
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) result[j][i] = matrix[i][j];
  }
  return result;
}

}  // namespace gcs
