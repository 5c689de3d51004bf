#pragma once
/// Points by their coordinates in a base of d points, which a rigid motion of all does not change and a
/// reflection changes only in the sign of the last one. With e = b₁ − b₀ and, in space, v the part of b₂ − b₀
/// that is perpendicular to e:
///   p = b₀ + ξ e + ζ e⊥              in the plane,
///   p = b₀ + ξ e + η v + ζ (e × v)   in space.
/// Nothing but the bilinear form p·q = Σ p_i q_i is used, so that complex placements are treated alike.

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace gcs {

/// d points, as columns.
using Simplex = Eigen::Matrix<std::complex<double>, 3, Eigen::Dynamic>;

/// Of the positions of all points, those of some.
Simplex columns(const Simplex& positions, const std::vector<int>& points);

/// ξ, η (0 in the plane) and ζ.
using SimplexCoordinates = Eigen::Vector3cd;

class SimplexFrame {
 public:
  /// Precondition: two or three points, no isotropic difference, not collinear.
  explicit SimplexFrame(const Simplex& base);

  SimplexCoordinates coordinates(const Eigen::Vector3cd& point) const;
  Eigen::Vector3cd point(const SimplexCoordinates& coordinates) const;

 private:
  Eigen::Vector3cd origin_;
  Eigen::Matrix3cd axes_;  ///< columns e, v, e × v; in the plane e, 0, e⊥
};

}  // namespace gcs
