#pragma once
/// 2-norm condition numbers of dense matrices.

#include <Eigen/Core>

namespace gcs {

/// Of the largest singular value to the smallest.
double singular_ratio(const Eigen::MatrixXcd& matrix);

/// The same to seven digits, or to the roundings that a large one magnifies, several times faster.
double rounded_singular_ratio(const Eigen::MatrixXd& matrix);
double rounded_singular_ratio(const Eigen::MatrixXcd& matrix);

}  // namespace gcs
