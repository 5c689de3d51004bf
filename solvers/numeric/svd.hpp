#pragma once
/// Eigen's singular value decompositions of matrices of any size, compiled once: each takes seconds.

#include <Eigen/SVD>

extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
extern template class Eigen::JacobiSVD<Eigen::MatrixXcd>;
extern template class Eigen::BDCSVD<Eigen::MatrixXd>;
extern template class Eigen::BDCSVD<Eigen::MatrixXcd>;
