#pragma once
/// The common tangents of four spheres as three equations in four homogeneous unknowns.
///
/// With one centre at the origin, u along the line, p its point with p·u = 0 and P = p·(u·u), the distances
/// of the other centres are linear in P (Hoffmann, Yuan 2000, section 4.1, equations (2)–(4) less (1)):
/// c_i·P = b_i(u) = ½[(u·u)(c_i·c_i + r_1² − r_i²) − (c_i·u)²]. Two of them give P = q(u) + τ n, n the unit
/// normal of their centres' plane; what is left is
///   f1 = hτ − κ(u) = 0,  f2 = τ l(u) + s(u) = 0,  f3 = τ² − ρ(u) = 0
/// with h = c_4·n, κ = b_4 − c_4·q, l = n·u, s = q·u, ρ = r_1²(u·u)² − q·q. The weights of u and τ are 1 and
/// 2, those of the equations 2, 3 and 4: 2·3·4/2 = 12 solutions, also where the centres are coplanar (h = 0)
/// and the published elimination of τ does not exist.

#include <Eigen/Core>
#include <complex>

#include "solvers/tangents/sphere.hpp"
#include "solvers/tangents/ternary_form.hpp"

namespace gcs {

inline constexpr std::array<int, 3> equation_weights{2, 3, 4};

/// A line as u and p of the header. Scalar is double or complex<double>.
template <class Scalar>
struct Tangent {
  Eigen::Matrix<Scalar, 3, 1> point;
  Eigen::Matrix<Scalar, 3, 1> direction;
};

/// The line with the direction u and P = `scaled_point` from `origin`: its point nearest to the coordinates'
/// origin and u·u = 1. Not finite when u is isotropic.
template <class Scalar>
Tangent<Scalar> line_through(const Eigen::Matrix<Scalar, 3, 1>& u,
                             const Eigen::Matrix<Scalar, 3, 1>& scaled_point, const Eigen::Vector3d& origin);

/// b(u) as a symmetric matrix, for the centre c from the first one.
Eigen::Matrix3d distance_matrix(const Eigen::Vector3d& c, DoubleDouble first_square, DoubleDouble square);

class TangentEquations {
 public:
  /// The unknowns are turned by `turn`, a rotation: (x, y, g) = turn · u. Precondition: the centres are not
  /// collinear; lengths are of order 1 at most.
  TangentEquations(const FourSpheres& spheres, const Eigen::Matrix3d& turn);

  double h() const { return h_; }
  const QuadraticForm& kappa() const { return kappa_; }
  const TernaryLinearForm& l() const { return l_; }
  const CubicForm& s() const { return s_; }
  const QuarticForm& rho() const { return rho_; }

  /// The line of a solution, in the spheres' coordinates, the point nearest to their origin and u·u = 1; not
  /// finite when u is isotropic.
  template <class Scalar>
  Tangent<Scalar> line(const Eigen::Matrix<Scalar, 3, 1>& turned_u, Scalar tau) const;

 private:
  Eigen::Matrix3d turn_;
  Eigen::Vector3d origin_;
  Eigen::Vector3d normal_;
  std::array<Eigen::Vector3d, 2> dual_;  ///< q = b_2 dual_[0] + b_3 dual_[1]; turned
  std::array<QuadraticForm, 2> b_;
  double h_ = 0;
  QuadraticForm kappa_;
  TernaryLinearForm l_;
  CubicForm s_;
  QuarticForm rho_;
};

/// |u·u| relative to |u|²: zero for an isotropic direction, that of a line at infinity.
template <class Scalar>
double nearness_to_isotropic(const Eigen::Matrix<Scalar, 3, 1>& u) {
  return std::abs((u.transpose() * u).value()) / u.squaredNorm();
}

/// Twice the area of the largest triangle of three centres, relative to the square of its longest side: 0
/// when the centres are collinear.
double relative_width(const FourSpheres& spheres);

}  // namespace gcs
