#pragma once
/// The bilinear form of C³, in which squared distances are polynomials in the coordinates.

#include <Eigen/Core>
#include <complex>

namespace gcs {

/// Σ u_i v_i, without conjugation.
inline std::complex<double> bilinear_product(const Eigen::Vector3cd& u, const Eigen::Vector3cd& v) {
  return (u.transpose() * v).value();
}

}  // namespace gcs
