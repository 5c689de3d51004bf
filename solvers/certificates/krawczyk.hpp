#pragma once
/// Krawczyk's test: does a box hold exactly one solution of a distance system, or none? (Krawczyk 1969; Moore
/// 1977; Neumaier, Interval methods for systems of equations, 1990, chapter 5.)

#include <Eigen/Core>
#include <optional>

#include "solvers/certificates/krawczyk_image.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {

/// All x with |x_i − mid_i| ≤ radius_i.
struct Box {
  Eigen::VectorXd mid;
  Eigen::VectorXd radius;
};

enum class BoxContent { unknown, no_solution, one_solution };

/// Proves what the box holds for all squared lengths within 2^-104 of `squares`, relatively, and all given
/// coordinates within DistanceSystem::coordinate_error of their doubles; the file's decimals are among them.
/// With C near the inverse of the Jacobian at the middle, all solutions in the box lie in
/// mid − C f(mid) + (I − C J(box))(box − mid); where that is inside the box there is exactly one, where it
/// misses the box there is none. Rounding is enclosed.
BoxContent krawczyk(const DistanceSystem& system, const std::vector<DoubleDouble>& squares, const Box& box);

/// A box along other axes: all mid + axes·z with |z_i| ≤ radius_i.
struct SkewBox {
  Eigen::VectorXd mid;
  Eigen::VectorXd radius;
};

/// Krawczyk's operator on such a box, in the coordinates z, of the same proof. Nothing where the Jacobian at
/// the middle is singular. Preconditions: `axes` are square and regular; `f` is at the middle, and the entries of its
/// Jacobian move by `jacobian_radius` within |x − mid| ≤ |axes|·radius.
std::optional<KrawczykImage<double>> krawczyk_image_along(const Eigen::MatrixXd& axes,
                                                          LinearisedSystem<double> f,
                                                          const Eigen::MatrixXd& jacobian_radius,
                                                          const Eigen::VectorXd& radius);

/// The same of a distance system.
std::optional<KrawczykImage<double>> krawczyk_image(const DistanceSystem& system,
                                                    const std::vector<DoubleDouble>& squares,
                                                    const Eigen::MatrixXd& axes, const SkewBox& box);

}  // namespace gcs
