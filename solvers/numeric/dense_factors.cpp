#include "solvers/numeric/dense_factors.hpp"

#include <Eigen/Eigenvalues>

namespace gcs {
namespace {

template <class Matrix, class Vector>
Vector shortest(const Matrix& a, const Vector& b, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Matrix> factors;
  if (threshold > 0) factors.setThreshold(threshold);
  factors.compute(a);
  return factors.solve(b);
}

}  // namespace

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold) {
  return shortest(a, b, threshold);
}
Eigen::VectorXcd shortest_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b, double threshold) {
  return shortest(a, b, threshold);
}

Eigen::MatrixXd orthogonal_factor(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& factors) {
  return factors.householderQ();
}
Eigen::MatrixXcd orthogonal_factor(const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd>& factors) {
  return factors.householderQ();
}

EigenSystem eigen_system(const Eigen::MatrixXd& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  return {solver.eigenvalues(), solver.eigenvectors(), solver.pseudoEigenvectors()};
}

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

SchurForm schur_form(const Eigen::MatrixXcd& matrix) {
  const Eigen::ComplexSchur<Eigen::MatrixXcd> solver(matrix);
  return {solver.matrixT(), solver.matrixU()};
}

}  // namespace gcs
