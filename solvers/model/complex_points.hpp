#pragma once
/// Complex solutions of point distance problems: placements in C³ with the bilinear form p·q = Σ p_i q_i, so
/// that a squared distance is a polynomial in the coordinates and not a modulus.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "solvers/numeric/wide_vector.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Column i is point i.
using ComplexPoints = Eigen::Matrix<std::complex<double>, 3, Eigen::Dynamic>;

/// Entry i is point i: for solutions whose distances are lost when their coordinates are rounded to doubles.
using WidePoints = std::vector<WideVector>;

WidePoints widened(const ComplexPoints& points);
/// To the nearest doubles.
ComplexPoints narrowed(const WidePoints& points);

/// The points of a figure, real or not, and the complex figure of these points.
ComplexPoints complex_points(const Figure& figure);
Figure complex_figure(const ComplexPoints& points);

/// The points moved by a complex rotation and a translation: `origin` at 0, `axis` at (d, 0, 0) with Re d ≥ 0
/// and, in space, `plane` at (x, y, 0) with Re y ≥ 0. Points that are there already are not touched: a
/// complex rotation has entries of any size and costs accuracy. Not finite when one of these directions is
/// isotropic (a vector of square 0).
ComplexPoints in_frame(const ComplexPoints& points, int dimension, const Reference& reference);

/// The same in space and in double-double, to a rounding of the rotation's entries.
WidePoints in_frame(const WidePoints& points, const Reference& reference);

/// The square of the distance of points a and b: a number in C.
std::complex<double> squared_distance(const ComplexPoints& points, int a, int b);
std::complex<double> squared_distance(const WidePoints& points, int a, int b);

/// q·q − square for the difference q of two points, in double-double: right to rounding however much cancels.
std::complex<double> squared_distance_excess(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b,
                                             DoubleDouble square);
std::complex<double> squared_distance_excess(const WideVector& a, const WideVector& b, DoubleDouble square);

/// The two points at given squared distances from three others: the foot in their plane, plus and minus a
/// normal. Nothing where the plane is isotropic or the three are collinear (to rounding).
std::optional<std::array<Eigen::Vector3cd, 2>> trilaterate(
    const std::array<Eigen::Vector3cd, 3>& centers, const std::array<std::complex<double>, 3>& squares);

/// |p_a − p_b|² = square.
struct DistanceEquation {
  int a = 0;
  int b = 0;
  DoubleDouble square;
};

struct ComplexRefinement {
  bool converged = false;
  int iterations = 0;
  double last_correction = 0;       ///< 2-norm, relative to the size of the figure
  double reciprocal_condition = 0;  ///< of the Jacobian with rows of 2-norm 1, 1-norm estimate
};

/// Newton's method for (|p_a − p_b|² − square)/2 = 0, all equations, with residuals in double-double. `frame`
/// names the points that stay at the origin, on the x-axis and in the xy-plane, where `points` must have
/// them; they and the other points named by the equations, in number as many unknown coordinates as
/// equations, are improved in place.
ComplexRefinement refine(std::span<const DistanceEquation> equations, const std::array<int, 3>& frame,
                         ComplexPoints& points);

/// The same with coordinates in double-double and Jacobians in doubles: it converges where these are regular
/// to rounding, by their condition times rounding a step, and then the coordinates are right to more than
/// doubles hold. Never to a multiple solution.
ComplexRefinement refine(std::span<const DistanceEquation> equations, const std::array<int, 3>& frame,
                         WidePoints& points);

}  // namespace gcs
