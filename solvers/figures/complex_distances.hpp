#pragma once
/// The distance equations of DistanceSystem at complex coordinates.

#include <Eigen/Core>
#include <vector>

#include "solvers/model/distance_system.hpp"

namespace gcs {

class ComplexDistances {
 public:
  /// `squares`: of the lengths, one per equation. Both must live as long as this.
  ComplexDistances(const DistanceSystem& system, const std::vector<DoubleDouble>& squares)
      : system_(system), squares_(squares) {}

  /// (p_a − p_b)·(p_a − p_b)/2 − a²/2 of every equation, rounded after the subtraction.
  Eigen::VectorXcd value(const Eigen::VectorXcd& x) const;
  /// Its derivative: equations × unknowns.
  Eigen::MatrixXcd jacobian(const Eigen::VectorXcd& x) const;

 private:
  Eigen::Matrix3Xd imaginary_points(const Eigen::VectorXcd& x) const;

  const DistanceSystem& system_;
  const std::vector<DoubleDouble>& squares_;
};

/// The complex figure of these free coordinates; a line's imaginary part is 0.
Figure complex_figure(const DistanceSystem& system, const Eigen::VectorXcd& x);

/// A complex figure of points, in the scene's frame, after as many steps of Newton's method as make its
/// relative residual smaller, three at most. Above 300 unknowns none is made.
Figure polished(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure);

}  // namespace gcs
