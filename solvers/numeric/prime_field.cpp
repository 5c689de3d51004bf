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

int rank(const ResidueMatrix& matrix) {
  return static_cast<int>(
      nmod_mat_rank(FlintMatrix(matrix, matrix.empty() ? 0 : matrix.front().size()).get()));
}

ResidueMatrix null_space(const ResidueMatrix& matrix, int columns) {
  const auto width = static_cast<std::size_t>(columns);
  FlintMatrix reduced(matrix, width);
  const auto rank = static_cast<std::size_t>(nmod_mat_rref(reduced.get()));
  ResidueMatrix basis;
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < width; ++column) {
    if (pivots.size() < rank && !reduced.at(pivots.size(), column).is_zero()) {
      pivots.push_back(column);
      continue;
    }
    ResidueVector vector(width);
    vector[column] = Residue(1);
    for (std::size_t i = 0; i < pivots.size(); ++i) vector[pivots[i]] = -reduced.at(i, column);
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
