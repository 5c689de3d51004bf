#pragma once
/// How far two placements of the same entities are apart: the largest distance of a point of one from the
/// same point of the other. Of a line its point nearest to the origin counts, and its unit direction, up to
/// sign, times `size`; of a plane its normal times `size`, and its offset, up to a sign of both. Complex coordinates differ by |Δ|. The numbers of a figure may have any number of
/// digits.

#include <array>
#include <span>

#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// What the coordinates of one figure are multiplied by, each 1 or −1: one of its mirror images.
using AxisSigns = std::array<int, 3>;

/// Those that leave the class of a figure in the scene's frame as it is: none but itself where positions are
/// given, and half-turns alone where mirror images are two.
std::vector<AxisSigns> mirror_images(const Scene& scene);

/// Of `a` from the mirror image of `b`. Precondition: they have the same entities.
double largest_distance(const Figure& a, const Figure& b, const AxisSigns& signs, double size);

/// The smallest one, from any of these mirror images. Precondition: there is one.
double least_distance(const Figure& a, const Figure& b, std::span<const AxisSigns> images, double size);

/// As largest_distance in as many digits as both are given with; rounded to a double at the end.
double largest_distance(const DecimalFigure& a, const DecimalFigure& b, const AxisSigns& signs, double size);

/// The nearest doubles; real where no imaginary part is anything but "0".
Figure figure_of(const DecimalFigure& decimals);

/// A figure's doubles to 40 significant digits, exact as far as any error of theirs goes. `error`, `unique`
/// and `bits` say nothing.
DecimalFigure decimals_of(const Figure& figure);

}  // namespace gcs
