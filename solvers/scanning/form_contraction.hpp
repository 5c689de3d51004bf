#pragma once
/// Linear equations between unknown and known forms: one step of an interval Newton method.

#include <Eigen/LU>

#include "solvers/numeric/affine_form.hpp"

namespace gcs {

/// Equations matrix · x = right that all x of interest satisfy. `terms`: magnitudes of what the matrix'
/// entries were added from, of which they are right to a few units of rounding.
template <int Size, int N>
struct FormEquations {
  using Matrix = Eigen::Matrix<double, Size, Size>;

  Matrix matrix, terms;
  std::array<AffineForm<N>, Size> right;

  /// inverse · right, and what the rounding of the matrix and its inverse leaves over of x, whose entries
  /// reach as far as `reach` says. Not finite where the matrix is singular.
  std::array<AffineForm<N>, Size> solve(const std::array<double, Size>& reach) const {
    const Matrix inverse = matrix.inverse();
    const Matrix defect = (inverse * matrix - Matrix::Identity()).cwiseAbs() +
                          16 * AffineForm<N>::epsilon * inverse.cwiseAbs() * terms;
    std::array<AffineForm<N>, Size> solved;
    for (int row = 0; row < Size; ++row)
      for (int i = 0; i < Size; ++i) {
        solved[row] = solved[row] + inverse(row, i) * right[i];
        solved[row].rest += defect(row, i) * reach[i];
      }
    return solved;
  }
};

template <int N>
FormVector<N> constant_form(const Eigen::Vector3d& x) {
  return {AffineForm<N>(x[0]), AffineForm<N>(x[1]), AffineForm<N>(x[2])};
}

template <int N>
AffineForm<N> dot(const Eigen::Vector3d& a, const FormVector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// What is unknown of a point's coordinates, together.
template <int N>
double unknown_of(const FormVector<N>& point) {
  return point[0].rest + point[1].rest + point[2].rest;
}

}  // namespace gcs
