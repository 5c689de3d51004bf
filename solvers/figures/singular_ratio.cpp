#include "solvers/figures/singular_ratio.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

template <class Matrix>
double ratio_of(const Matrix& matrix) {
  const Eigen::VectorXd singular = Eigen::BDCSVD<Matrix>(matrix).singularValues();
  const double smallest = singular.minCoeff();
  return smallest > 0 ? singular.maxCoeff() / smallest : std::numeric_limits<double>::infinity();
}

/// The eigenvalues of the Gram matrix are the squares of the singular values, of which the smallest one is off by some
/// roundings of the largest.
template <class Matrix>
double rounded_ratio_of(const Matrix& matrix) {
  constexpr double small = 1e4;
  const Matrix gram = matrix.adjoint() * matrix;
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Matrix>(gram, Eigen::EigenvaluesOnly).eigenvalues();
  const double ratio = std::sqrt(squares.maxCoeff() / squares.minCoeff());
  return ratio <= small ? ratio : ratio_of(matrix);
}

}  // namespace

double singular_ratio(const Eigen::MatrixXd& matrix) { return ratio_of(matrix); }
double singular_ratio(const Eigen::MatrixXcd& matrix) { return ratio_of(matrix); }
double rounded_singular_ratio(const Eigen::MatrixXd& matrix) { return rounded_ratio_of(matrix); }
double rounded_singular_ratio(const Eigen::MatrixXcd& matrix) { return rounded_ratio_of(matrix); }

}  // namespace gcs
