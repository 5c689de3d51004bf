#include "solvers/numeric/svd.hpp"

template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::JacobiSVD<Eigen::MatrixXcd>;
template class Eigen::BDCSVD<Eigen::MatrixXd>;
template class Eigen::BDCSVD<Eigen::MatrixXcd>;
