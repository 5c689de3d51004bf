#include "solvers/figures/singular_ratio.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <vector>

namespace gcs {
namespace {

template <class Matrix>
double ratio_of(const Matrix& matrix) {
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Matrix>(matrix).singularValues();
  const double smallest = singular.minCoeff();
  return smallest > 0 ? singular.maxCoeff() / smallest : std::numeric_limits<double>::infinity();
}

/// The lower half of the Gram matrix. Rows of Jacobians have few entries.
template <class Matrix>
Matrix lower_gram_matrix(const Matrix& matrix) {
  Matrix gram = Matrix::Zero(matrix.cols(), matrix.cols());
  std::vector<Eigen::Index> entries;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    entries.clear();
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      if (matrix(row, column) != 0.0) entries.push_back(column);
    for (std::size_t j = 0; j < entries.size(); ++j)
      for (std::size_t i = j; i < entries.size(); ++i)
        gram(entries[i], entries[j]) +=
            Eigen::numext::conj(matrix(row, entries[i])) * matrix(row, entries[j]);
  }
  return gram;
}

/// The eigenvalues of the Gram matrix are the squares of the singular values, ascending; small ones are off by some
/// roundings of the largest.
template <class Matrix>
Eigen::VectorXd rounded_squares(const Matrix& lower_gram) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(lower_gram, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Where the smallest singular value is lost in the rounding of the squares, it is one over the largest of the inverse.
template <class Matrix>
double rounded_ratio_of(const Matrix& matrix) {
  constexpr double small = 1e4;
  const Eigen::VectorXd squares = rounded_squares(lower_gram_matrix(matrix));
  const double ratio = std::sqrt(squares.maxCoeff() / squares.minCoeff());
  if (ratio <= small) return ratio;
  if (matrix.rows() != matrix.cols()) return ratio_of(matrix);
  const Matrix inverse = matrix.partialPivLu().inverse();
  const Matrix gram = inverse.adjoint() * inverse;
  if (!gram.allFinite()) return std::numeric_limits<double>::infinity();
  return std::sqrt(squares.maxCoeff()) * std::sqrt(rounded_squares(gram).maxCoeff());
}

}  // namespace

double singular_ratio(const Eigen::MatrixXcd& matrix) { return ratio_of(matrix); }
double rounded_singular_ratio(const Eigen::MatrixXd& matrix) { return rounded_ratio_of(matrix); }
double rounded_singular_ratio(const Eigen::MatrixXcd& matrix) { return rounded_ratio_of(matrix); }

}  // namespace gcs
