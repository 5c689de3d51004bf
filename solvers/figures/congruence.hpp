#pragma once
/// Whether two sets of points are images of each other by a motion or a reflection, point by point.

#include "solvers/model/complex_points.hpp"

namespace gcs {

/// False when no motion or reflection of C³ (of R³ for real points) takes every point of `a` to within
/// `tolerance` of the same point of `b`. True otherwise, and where doubles cannot tell: when a direction to
/// compare along is nearly isotropic, so that complex rotations have entries of any size.
///
/// Distances alone feel a small height z over a plane only by z²; here z itself is compared. Frames are put
/// through the points furthest apart (Gram–Schmidt with pivots), one axis after another, and coordinates are
/// compared up to the sign of each axis. Precondition: as many points in both, at least one.
bool may_be_congruent(ComplexPoints a, ComplexPoints b, double tolerance);

}  // namespace gcs
