#pragma once
/// How good a simple line at given distances from four points is, by means of the tests' own.

#include <Eigen/Core>

#include "solvers/model/complex_lines.hpp"

namespace gcs {

struct FourDistances {
  Eigen::Matrix<double, 3, 4> centers;
  Eigen::Vector4d lengths;  ///< > 0
};

/// How much the relative residual of an exact line may grow when its coordinates are rounded to the nearest
/// doubles, each by at most the unit roundoff ε = 2⁻⁵³ of its modulus.
///
/// Let {p + s·u} be the line, u·u = 1 and p·u = 0, at the distance r from c. With a = c·u its point
/// q = p + a·u is the foot of c: n = c − q has n·u = 0 and n·n = r². Let δp and δu be the changes of p and u,
/// and u' = u + δu. The changed line holds q + δ with δ = δp + a·δu,
/// so that the square of its distance from c is
///   (n − δ)·(n − δ) − ((n − δ)·u')²/(u'·u') = r² − 2n·δ + δ·δ − κ²/(u'·u'),  κ = n·δu − δ·u − δ·δu.
/// With |δp_i| ≤ ε|p_i| and |δu_i| ≤ ε|u_i|, so |δ_i| ≤ e_i = ε(|p_i| + |a u_i|), it is off r² by at most
///   E = 2Σ|n_i|e_i + Σe_i² + K²/(1 − 3ε Σ|u_i|²),  K = Σ(ε|n_i u_i| + (1 + ε) e_i|u_i|).
/// The relative residual is |d² − r²|/(|d + r| r) with Re d ≥ 0, so at most E/(r² + r·√(r² − E)). It is large
/// for complex lines that are far away or nearly isotropic, |u|² ≫ 1 with u·u = 1.
double residual_of_rounding(const FourDistances& given, const ComplexLine& line);

struct WideLine {
  double residual = 0;  ///< relative
  double moved = 0;     ///< how far it is from the line that it was, relative to 1 + |p| and |u|
};

/// The line by Newton's method on u·u = 1, p·u = 0 and the four distances, all in double-double.
/// Precondition: centres and lengths of order 1.
WideLine refined_in_double_double(const FourDistances& given, const ComplexLine& line);

}  // namespace gcs
