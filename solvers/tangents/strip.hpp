#pragma once
/// Four centres near to a line, and isotropic coordinates about it.
///
/// With e the direction of the two centres furthest apart and f, g completing it to an orthonormal frame, a
/// vector v has the coordinates v_x = e·v and v_± = f·v ± i g·v, so that
///   v·w = v_x w_x + (v_+ w_- + v_- w_+)/2.
/// Multiplying v_+ by 1/b and v_- by b is a rotation about e by a complex angle: no distance changes. Where
/// the centres are off a line by ε of their distances, the tangents' directions have v_x, v_+ and v_- of the
/// orders 1, 1/ε and ε or 1, ε and 1/ε. In Cartesian coordinates that is lost to cancellation; here a b of
/// the order of 1/ε makes all three of order 1, and with them the line's equations well-conditioned.

#include <Eigen/Core>
#include <array>

#include "solvers/numeric/wide_vector.hpp"
#include "solvers/tangents/sphere.hpp"

namespace gcs {

/// v·w of vectors in isotropic coordinates.
inline std::complex<double> isotropic_product(const Eigen::Vector3cd& v, const Eigen::Vector3cd& w) {
  return v[0] * w[0] + (v[1] * w[2] + v[2] * w[1]) / 2.0;
}
inline ComplexDoubleDouble isotropic_product(const WideVector& v, const WideVector& w) {
  return v[0] * w[0] + widened(std::complex(0.5)) * (v[1] * w[2] + v[2] * w[1]);
}

/// A vector after the rotation by b, which is exact where b is a power of two.
inline Eigen::Vector3cd turned_by(double b, const Eigen::Vector3cd& v) { return {v[0], v[1] / b, v[2] * b}; }
inline WideVector turned_by(double b, const WideVector& v) {
  return {v[0], widened(std::complex(1 / b)) * v[1], widened(std::complex(b)) * v[2]};
}

/// What v·w is as a function of w.
inline Eigen::RowVector3cd isotropic_dual(const Eigen::Vector3cd& v) {
  return {v[0], v[2] / 2.0, v[1] / 2.0};
}

class Strip {
 public:
  /// Precondition: the centres are not all the same.
  explicit Strip(const FourSpheres& spheres);

  /// Of a vector in the spheres' coordinates, to double-double.
  WideVector isotropic(const WideVector& cartesian) const;
  WideVector cartesian(const WideVector& isotropic) const;

  /// The first centre.
  const Eigen::Vector3d& origin() const { return spheres_[0].center; }
  WideVector wide_origin() const;
  /// Of the centres but the first, from the first.
  const std::array<WideVector, 3>& centers() const { return centers_; }

  /// The largest power of two by which distances from the axis through the first centre may be multiplied
  /// without exceeding the largest distance of two centres; at least 1.
  double widening() const { return widening_; }

  /// Of the rotations that tangents are balanced by.
  double largest_rotation() const { return 2 * widening_; }

  /// The spheres with their centres' distances from the axis multiplied by the widening.
  FourSpheres widened_spheres() const;

 private:
  using Axis = std::array<DoubleDouble, 3>;

  void choose_axes();
  void choose_widening();

  FourSpheres spheres_;
  std::array<Axis, 3> axes_;  ///< e, f, g, orthonormal to double-double
  std::array<WideVector, 3> centers_;
  double length_ = 0;  ///< the largest distance of two centres
  double widening_ = 1;
};

/// Relative width (tangent_equations.hpp) below which Cartesian coordinates lose so much that simple lines
/// are polished in isotropic ones, and so are lines as near to an isotropic direction as its square. Above it
/// both ways are good, these the slower one.
inline constexpr double narrow = 1.0 / 32;

/// Relative width below which different lines come as near to each other in Cartesian coordinates as the
/// rounded parts of a multiple one, or to infinity, and are taken for it: directions are as near to isotropic
/// as its square.
inline constexpr double deceptive = 1.0 / 256;

}  // namespace gcs
