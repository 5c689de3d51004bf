#pragma once
/// Derivatives of the distances of a scene that has lines.

#include <Eigen/Core>

#include "solvers/model/scene.hpp"

namespace gcs {

/// Rows: (d² − a²)/2 of every constraint, then u·dp = 0 and u·du = 0 of every free line, which take away the
/// sliding of its point and the length of its direction. Columns: coordinates of the free points, then point
/// and direction of the free lines. Fixed are what the file gives a position and, in a frame, the reference
/// line and all of the height point but z. Complex figures by the bilinear form. Precondition: the figure is
/// in the frame; every direction has u·u = 1.
Eigen::MatrixXcd line_jacobian(const Scene& scene, const Figure& figure);

}  // namespace gcs
