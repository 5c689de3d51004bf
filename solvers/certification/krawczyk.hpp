#pragma once
/// Krawczyk's test: does a box hold exactly one solution of a distance system, or none? (Krawczyk 1969; Moore
/// 1977; Neumaier, Interval methods for systems of equations, 1990, chapter 5.)

#include <Eigen/Core>

#include "solvers/model/distance_system.hpp"

namespace gcs {

/// All x with |x_i − mid_i| ≤ radius_i.
struct Box {
  Eigen::VectorXd mid;
  Eigen::VectorXd radius;
};

enum class BoxContent { unknown, no_solution, one_solution };

/// Proves, for lengths whose squares are `squares`, what the box holds: with C near the inverse of the
/// Jacobian at the middle, all solutions in the box lie in mid − C f(mid) + (I − C J(box))(box − mid); where
/// that is inside the box there is exactly one, where it misses the box there is none. Rounding is enclosed.
BoxContent krawczyk(const DistanceSystem& system, const std::vector<DoubleDouble>& squares, const Box& box);

}  // namespace gcs
