#pragma once
/// Equations that sum squares of unknowns and of differences of two, as those of distances between points do: exact sums of
/// doubles, several times faster than forms with coefficients.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "solvers/certificates/krawczyk_image.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {

struct SquaredDifferences {
  /// Nothing where an equation has another form or a left side with a constant.
  static std::optional<SquaredDifferences> of(const QuadraticSystem& system);

  /// Σ (x[pair[0]] − x[pair[1]])² = given, where x[−1] = 0.
  struct Equation {
    std::vector<std::array<int, 2>> pairs;
    ComplexDoubleDouble given;  ///< right to 2^-100 of its size
  };

  std::vector<Equation> equations;
  Eigen::MatrixXd curvature;  ///< how far the entries of the Jacobian move when every x_i moves by 1
};

/// At a point. Scalar: double, where what is given is real, or std::complex<double>.
template <typename Scalar>
LinearisedSystem<Scalar> linearised(const SquaredDifferences& system,
                                    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x);

/// How far the entries of the Jacobian move at most within |x_i − mid_i| ≤ radius_i, wherever the middle is.
template <typename Scalar>
Eigen::MatrixXd jacobian_radius(const SquaredDifferences& system,
                                const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>&,
                                const Eigen::VectorXd& radius) {
  return system.curvature * radius.maxCoeff();
}

}  // namespace gcs
