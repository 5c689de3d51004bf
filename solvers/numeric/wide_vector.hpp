#pragma once
/// Vectors of C³ in double-double, with the bilinear form of bilinear_product.hpp.

#include <Eigen/Core>
#include <array>

#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {

using WideVector = std::array<ComplexDoubleDouble, 3>;

inline WideVector widened(const Eigen::Vector3cd& v) { return {widened(v[0]), widened(v[1]), widened(v[2])}; }
/// To the nearest doubles.
inline Eigen::Vector3cd narrowed(const WideVector& v) { return {v[0].value(), v[1].value(), v[2].value()}; }

/// a − b exactly.
inline WideVector wide_difference(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b) {
  return {wide_difference(a[0], b[0]), wide_difference(a[1], b[1]), wide_difference(a[2], b[2])};
}
inline WideVector wide_difference(const WideVector& a, const WideVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline WideVector operator*(const ComplexDoubleDouble& factor, const WideVector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// Σ u_i v_i, without conjugation.
inline ComplexDoubleDouble bilinear_product(const WideVector& u, const WideVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// Orthogonal to u and v for the bilinear product.
inline WideVector cross_product(const WideVector& u, const WideVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

}  // namespace gcs
