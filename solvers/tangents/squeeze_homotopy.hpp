#pragma once
/// The common tangents of four spheres as their centres and radii move, in isotropic coordinates.
///
/// u is along the line, P = p·(u·u) with p·u = 0 and the first centre as the origin. The distances of the
/// others are, with isotropic coordinates of the c_i (strip.hpp),
///   c_i·P − ½(u·u)(c_i·c_i + r_1² − r_i²) + ½(c_i·u)² = 0
/// (Hoffmann, Yuan 2000, section 4.1, (2)–(4) less (1)): linear in the coordinates of P and the products of
/// those of u. Of this 3 × 9 matrix the rows are combined to those of the identity in the columns that
/// complete pivoting chooses, whatever these are: that is the elimination that the placement conditions best.
/// With P·u = 0, P·P = r_1²(u·u)² and a·u = 1, which fixes the size of u, there are six equations.

#include <Eigen/Core>
#include <complex>

#include "solvers/tangents/scaled_line.hpp"
#include "solvers/tracking/path_tracker.hpp"

namespace gcs {

/// Four complex spheres, the first centre being the origin.
struct ComplexSpheres {
  Eigen::Matrix3cd centers;  ///< columns in isotropic coordinates: the other three
  Eigen::Vector3cd squares;  ///< of their radii
  std::complex<double> first_square;

  ComplexSpheres turned(double b) const;
};

class SqueezeHomotopy {
 public:
  static constexpr int unknowns = 6;  ///< the coordinates of u and P
  using Vector = ComplexVector<unknowns>;

  /// Centres and squares move along straight lines. `at_start` gives the patch: a·u = 1 there.
  SqueezeHomotopy(const ComplexSpheres& from, const ComplexSpheres& to, const ScaledLine& at_start);

  HomotopyValue<unknowns> at(const Vector& x, std::complex<double> t) const;

 private:
  using Equations = Eigen::Matrix<std::complex<double>, 3, 9>;

  /// Columns: coordinates of P, then products of those of u.
  static Equations equations_of(const ComplexSpheres& spheres);

  std::array<Equations, 3> equations_;  ///< at t = 0, 1/2 and 1: quadratic in t
  std::complex<double> square_from_, square_change_;
  Eigen::RowVector3cd patch_;
};

}  // namespace gcs
