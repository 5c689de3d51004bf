#pragma once
/// A point and its distance from the line that is sought: the line touches the sphere.

#include <Eigen/Core>
#include <array>

#include "solvers/numeric/double_double.hpp"

namespace gcs {

struct Sphere {
  Eigen::Vector3d center;
  DoubleDouble square;  ///< of the radius, ≥ 0
};

using FourSpheres = std::array<Sphere, 4>;

}  // namespace gcs
