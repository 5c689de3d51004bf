#pragma once
/// Complex lines: {point + s·direction} in C³ with the bilinear form p·q = Σ p_i q_i, so that the squared
/// distance of a point is a rational function of the coordinates and not a modulus.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "solvers/model/complex_points.hpp"

namespace gcs {

struct ComplexLine {
  Eigen::Vector3cd point;
  Eigen::Vector3cd direction;  ///< not isotropic: direction·direction ≠ 0
};

/// The lines of a figure, real or not.
std::vector<ComplexLine> complex_lines(const Figure& figure);

/// Replaces the lines of a complex figure.
void set_complex_lines(const std::vector<ComplexLine>& lines, Figure& figure);

/// The figure of these points and lines or, where it is real, of their real parts.
Figure figure_of(const ComplexPoints& points, const std::vector<ComplexLine>& lines, bool is_real);

/// The same line by the point with point·direction = 0 and a direction with direction·direction = 1, whose
/// first component that is not zero (above 1e-9 of the largest) has a positive real part or, that being zero,
/// a positive imaginary part. A line that is so already, to the rounding of its coordinates, is turned at most:
/// every further rounding of a large coordinate moves the line off its distances.
ComplexLine normalised(const ComplexLine& line);
std::vector<ComplexLine> normalised(std::vector<ComplexLine> lines);

/// The point q of the line with (p − q)·direction = 0.
Eigen::Vector3cd foot(const ComplexLine& line, const Eigen::Vector3cd& point);

/// The figure moved by a complex rotation and a translation that put the line on the x-axis and the point
/// `height` on the z-axis, with a coordinate of non-negative real part. Not finite when the point lies on an
/// isotropic perpendicular of the line.
Figure moved_to_line(const Figure& figure, int line, int height);

/// d² − square for the distance d of a point: (w × u)·(w × u)/(u·u) − square with w from the line's point to
/// this one and the direction u. The numerator is in double-double: right to rounding however much cancels.
std::complex<double> squared_distance_excess(const Eigen::Vector3cd& point, const ComplexLine& line,
                                             DoubleDouble square);

}  // namespace gcs
