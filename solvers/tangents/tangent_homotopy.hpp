#pragma once
/// The common tangents of four spheres by following 24 paths, one for each line and orientation.
///
/// u is along the line, P = p·(u·u) with p·u = 0 and one centre as the origin. Equations (2)–(4) less (1) of
/// Hoffmann, Yuan 2000, section 4.1, are c_i·P = b_i(u) (tangent_equations.hpp). In an orthonormal frame in
/// which the matrix of the c_i is triangular, QR with pivots, the first gives P·e_1 as a quadratic form, and
/// m = P·e_2 and n = P·e_3 stay unknowns:
///   r_22 m = k_2(u),  r_23 m + r_33 n = k_3(u),  P·u = 0,  P·P = r_1²(u·u)²,  (a·u)² = 1
/// with a random complex vector a. Eliminating m and n gives the published system of degrees 2, 3 and 4 in u,
/// but divides by the heights r_22 and r_33, which coplanar centres lose and nearly collinear ones nearly.
/// The weights of u and of m, n are 1 and 2, those of the equations 2, 2, 3, 4 and 2: 2·2·3·4·2/(2·2) = 24
/// solutions, two for each line. The published normalisation u·u = 1 sends isotropic directions to infinity
/// and distant lines near to it, a random one leaves all solutions at finite places. Start: x² = 1, m = y²,
/// n = g², y³ = 1, n² = 1, whose 24 solutions are known.
///
/// Where the centres are nearly collinear, solutions come near to each other and to isotropic directions in
/// these coordinates. The paths lead to the lines of spheres whose centres are moved apart then, and these
/// are followed further in other coordinates (squeezed_tangents.hpp).

#include <cstdint>
#include <random>
#include <stop_token>
#include <vector>

#include "solvers/tangents/tangent_ends.hpp"

namespace gcs {

class TangentHomotopy {
 public:
  static constexpr int unknowns = 5;  ///< x, y, g, m, n

  /// a and γ are random. Precondition: the centres are not collinear; lengths are of order 1.
  TangentHomotopy(const FourSpheres& spheres, std::mt19937_64& random);

  HomotopyValue<unknowns> at(const ComplexVector<unknowns>& x, std::complex<double> t) const;
  /// Of a zero at t = 1; not finite when u is isotropic.
  ComplexTangent line(const ComplexVector<unknowns>& x) const;
  /// Whether u is isotropic.
  bool is_at_infinity(const ComplexVector<unknowns>& x) const;
  /// The 24 zeros at t = 0.
  static std::vector<ComplexVector<unknowns>> starts();

 private:
  SystemValue<unknowns> target(const ComplexVector<unknowns>& x) const;

  /// P in the frame.
  Eigen::Vector3cd scaled_point(const ComplexVector<unknowns>& x) const;

  Eigen::Vector3d origin_;
  Eigen::Matrix3d frame_;
  double square_ = 0;                      ///< of the first radius
  Eigen::Matrix3d along_;                  ///< P·e_1 as a quadratic form
  std::array<Eigen::Matrix3d, 2> across_;  ///< the right sides of the two equations in m and n
  std::array<Eigen::Vector2d, 2> weight_;  ///< the coefficients of m and n
  std::complex<double> gamma_;
  Eigen::Vector3cd patch_;  ///< a
};

/// Follows all paths and polishes the lines where they end like common_tangents: a regular end is a simple
/// line, however many paths end there; the multiplicity of a singular one is half the number of its paths.
/// Reproducible from the seed. Preconditions as for common_tangents. `monitor` may be null.
FollowedTangents follow_tangents(const FourSpheres& spheres, std::uint64_t seed, const std::stop_token& stop,
                                 Monitor* monitor, WorkCounters& work);

}  // namespace gcs
