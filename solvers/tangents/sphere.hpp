#pragma once
/// A point and its distance from the line that is sought: the line touches the sphere.

#include <Eigen/Core>
#include <array>

#include "solvers/numeric/double_double.hpp"

namespace gcs {

struct Sphere {
  Eigen::Vector3d center;
  DoubleDouble square;  ///< of the radius, ≥ 0
  /// What the rounding of the centre has left out: beside a line that all centres are near to that may be a good part of how
  /// far they are off it.
  Eigen::Vector3d center_rest{0, 0, 0};

  DoubleDouble coordinate(int axis) const { return two_sum(center[axis], center_rest[axis]); }
};

using FourSpheres = std::array<Sphere, 4>;

}  // namespace gcs
