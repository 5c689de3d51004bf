#pragma once
/// What is made of factors of dense matrices, compiled once: as templates of Eigen in the sources that ask for it, that was a
/// tenth of a build.

#include <Eigen/LU>
#include <Eigen/QR>

namespace gcs {

/// The shortest x of those with the least |a x − b|. Pivots below `threshold` of the largest count as 0; without one those
/// that rounding leaves.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold = 0);
Eigen::VectorXcd shortest_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b,
                                   double threshold = 0);

/// The orthogonal or unitary factor, square: its first columns span those of the matrix, in the order of its pivots.
Eigen::MatrixXd orthogonal_factor(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& factors);
Eigen::MatrixXcd orthogonal_factor(const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd>& factors);

/// Eigenvalues with their vectors as columns, those of a conjugate pair also as a real and an imaginary part in
/// `real_vectors`. Without values where the iterations do not converge.
struct EigenSystem {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  Eigen::MatrixXd real_vectors;
};
EigenSystem eigen_system(const Eigen::MatrixXd& matrix);
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix);

/// m = u t u*, u unitary and t upper triangular with the eigenvalues on its diagonal.
struct SchurForm {
  Eigen::MatrixXcd t;
  Eigen::MatrixXcd u;
};
SchurForm schur_form(const Eigen::MatrixXcd& matrix);

}  // namespace gcs
