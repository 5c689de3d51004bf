#pragma once
/// The bilinear form of C³, in which squared distances are polynomials in the coordinates.

#include <Eigen/Core>
#include <complex>

namespace gcs {

/// Σ u_i v_i, without conjugation.
inline std::complex<double> bilinear_product(const Eigen::Vector3cd& u, const Eigen::Vector3cd& v) {
  return (u.transpose() * v).value();
}

/// Orthogonal to u and v for the bilinear product; Eigen's conjugates.
inline Eigen::Vector3cd cross_product(const Eigen::Vector3cd& u, const Eigen::Vector3cd& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

}  // namespace gcs
