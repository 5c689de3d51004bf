#pragma once
/// A line by its direction u and P = p·(u·u), p its point with p·u = 0 from the first of four centres, in
/// isotropic coordinates (strip.hpp), up to (u, P) → (λu, λ²P): of every line, also one at infinity.

#include <Eigen/Core>

#include "solvers/tangents/strip.hpp"
#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

struct ScaledLine {
  Eigen::Vector3cd direction;     ///< u
  Eigen::Vector3cd scaled_point;  ///< P

  /// Of a line that is given in the spheres' coordinates, its point the one nearest to the first centre. Where its direction
  /// is nearly isotropic rounding leaves nothing of the smaller of u_+ and u_-, nor of that of the point: they are what
  /// u·u = 1 and p·u = 0 say.
  static ScaledLine of(const Strip& strip, const Tangent<std::complex<double>>& line);

  /// In the coordinates after a rotation by b (strip.hpp).
  ScaledLine turned(double b) const;

  /// The b, a power of two, for which u_+ and u_- are of the same size, within [1/largest, largest].
  double balancing_rotation(double largest) const;

  /// The same line with |u|² and |P| at most 1 and one of them 1.
  ScaledLine normalised() const;

  /// The line of the conjugate coordinates.
  ScaledLine conjugate() const;
};

/// The largest difference of direction and point of two lines with u·u = 1 relative to their size, after the rotation that
/// balances the first, within [1/largest, largest].
double difference(const ScaledLine& a, const ScaledLine& b, double largest);

}  // namespace gcs
