#include "solvers/certificates/figure_distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <utility>

#include "solvers/elements/system_builder.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {
namespace {

using Differences = std::array<std::complex<double>, 3>;

double length(const Differences& differences) {
  double result = 0;
  for (const std::complex<double>& difference : differences)
    result = std::hypot(result, std::abs(difference));
  return result;
}

// ---- doubles

/// Of a vector.
struct ComplexParts {
  const Eigen::Vector3d re;
  const Eigen::Vector3d im;
};

ComplexParts point_of(const Figure& figure, Eigen::Index point) {
  return {figure.points.col(point), figure.imaginary.cols() == 0
                                        ? Eigen::Vector3d::Zero()
                                        : Eigen::Vector3d(figure.imaginary.col(point))};
}

double distance(const ComplexParts& a, const ComplexParts& b, const AxisSigns& signs, int sign = 1) {
  Differences differences;
  for (int axis = 0; axis < 3; ++axis) {
    const double s = sign * signs[static_cast<std::size_t>(axis)];
    differences[static_cast<std::size_t>(axis)] = {a.re[axis] - s * b.re[axis], a.im[axis] - s * b.im[axis]};
  }
  return length(differences);
}

ComplexParts line_part(const Figure& figure, std::size_t line, Eigen::Vector3d LinePosition::*part) {
  return {figure.lines[line].*part,
          figure.is_real() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(figure.imaginary_lines[line].*part)};
}

ComplexParts normal_of(const Figure& figure, std::size_t plane) {
  return {figure.planes[plane].normal, figure.is_real()
                                           ? Eigen::Vector3d::Zero()
                                           : Eigen::Vector3d(figure.imaginary_planes[plane].normal)};
}

std::complex<double> offset_of(const Figure& figure, std::size_t plane) {
  return {figure.planes[plane].offset, figure.is_real() ? 0 : figure.imaginary_planes[plane].offset};
}

// ---- decimals

/// Four bits a digit, of the longest text.
slong bits_of(const DecimalNumber& number) {
  return 64 + 4 * static_cast<slong>(std::max(number.re.size(), number.im.size()));
}

double part_difference(const std::string& a, const std::string& b, int sign, slong bits) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_set_str(x, a.c_str(), bits);
  arb_set_str(y, b.c_str(), bits);
  if (sign > 0)
    arb_sub(x, x, y, bits);
  else
    arb_add(x, x, y, bits);
  const double difference = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arb_clear(x);
  arb_clear(y);
  return difference;
}

/// a − sign·b
std::complex<double> number_difference(const DecimalNumber& a, const DecimalNumber& b, int sign) {
  const slong bits = std::max(bits_of(a), bits_of(b));
  return {part_difference(a.re, b.re, sign, bits), part_difference(a.im, b.im, sign, bits)};
}

double distance(const DecimalVector& a, const DecimalVector& b, const AxisSigns& signs, int sign = 1) {
  Differences differences;
  for (std::size_t axis = 0; axis < 3; ++axis)
    differences[axis] = number_difference(a[axis], b[axis], sign * signs[axis]);
  return length(differences);
}

std::string decimal(double value) { return fmt::format("{:.40g}", value); }

DecimalVector decimals_of(const ComplexParts& vector) {
  DecimalVector decimals;
  for (int axis = 0; axis < 3; ++axis)
    decimals[static_cast<std::size_t>(axis)] = {decimal(vector.re[axis]), decimal(vector.im[axis])};
  return decimals;
}

/// Whether a change of the signs of these axes leaves the class of a figure as it is, in the frame of a general scene.
bool keeps_class(const SceneFrame& frame, unsigned mask) {
  for (SignMask generators = 0; generators < first_turning; ++generators) {
    unsigned changed = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (std::popcount(frame.axis(axis) & generators) % 2 != 0) changed |= 1U << axis;
    if (changed == mask) return true;
  }
  return false;
}

}  // namespace

std::vector<AxisSigns> mirror_images(const Scene& scene) {
  std::vector<AxisSigns> images;
  const int count = sign_patterns(scene.is_anchored(), scene.dimension());
  for (int mask = 0; mask < count; ++mask)
    if (!scene.problem().is_general() || keeps_class(SceneFrame(scene), static_cast<unsigned>(mask)))
      images.push_back({(mask & 1) != 0 ? -1 : 1, (mask & 2) != 0 ? -1 : 1, (mask & 4) != 0 ? -1 : 1});
  return images;
}

double largest_distance(const Figure& a, const Figure& b, const AxisSigns& signs, double size) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.points.cols(); ++i)
    largest = std::max(largest, distance(point_of(a, i), point_of(b, i), signs));
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const auto apart = [&](Eigen::Vector3d LinePosition::*part, int sign) {
      return distance(line_part(a, i, part), line_part(b, i, part), signs, sign);
    };
    const double turn = std::min(apart(&LinePosition::direction, 1), apart(&LinePosition::direction, -1));
    largest = std::max({largest, apart(&LinePosition::point, 1), size * turn});
  }
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    const auto apart = [&](int sign) {
      const double shift = std::abs(offset_of(a, i) - double(sign) * offset_of(b, i));
      return std::max(size * distance(normal_of(a, i), normal_of(b, i), signs, sign), shift);
    };
    largest = std::max(largest, std::min(apart(1), apart(-1)));
  }
  return largest;
}

double least_distance(const Figure& a, const Figure& b, std::span<const AxisSigns> images, double size) {
  double least = std::numeric_limits<double>::infinity();
  for (const AxisSigns& signs : images) least = std::min(least, largest_distance(a, b, signs, size));
  return least;
}

double largest_distance(const DecimalFigure& a, const DecimalFigure& b, const AxisSigns& signs, double size) {
  double largest = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    largest = std::max(largest, distance(a.points[i], b.points[i], signs));
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const double turn = std::min(distance(a.lines[i].direction, b.lines[i].direction, signs),
                                 distance(a.lines[i].direction, b.lines[i].direction, signs, -1));
    largest = std::max({largest, distance(a.lines[i].point, b.lines[i].point, signs), size * turn});
  }
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    const auto apart = [&](int sign) {
      const double shift = std::abs(number_difference(a.planes[i].offset, b.planes[i].offset, sign));
      return std::max(size * distance(a.planes[i].normal, b.planes[i].normal, signs, sign), shift);
    };
    largest = std::max(largest, std::min(apart(1), apart(-1)));
  }
  return largest;
}

Figure figure_of(const DecimalFigure& decimals) {
  const auto count = static_cast<Eigen::Index>(decimals.points.size());
  Figure figure{Eigen::Matrix3Xd::Zero(3, count), {}};
  Eigen::Matrix3Xd imaginary = figure.points;
  bool is_real = true;
  const auto read = [&](const DecimalVector& vector, double* re, double* im) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      re[axis] = std::strtod(vector[axis].re.c_str(), nullptr);
      im[axis] = std::strtod(vector[axis].im.c_str(), nullptr);
      is_real = is_real && vector[axis].im == "0";
    }
  };
  for (Eigen::Index i = 0; i < count; ++i)
    read(decimals.points[static_cast<std::size_t>(i)], figure.points.col(i).data(), imaginary.col(i).data());
  std::vector<LinePosition> imaginary_lines;
  for (const DecimalFigure::Line& line : decimals.lines) {
    LinePosition& re = figure.lines.emplace_back();
    LinePosition& im = imaginary_lines.emplace_back();
    read(line.point, re.point.data(), im.point.data());
    read(line.direction, re.direction.data(), im.direction.data());
  }
  std::vector<PlanePosition> imaginary_planes;
  for (const DecimalFigure::Plane& plane : decimals.planes) {
    PlanePosition& re = figure.planes.emplace_back();
    PlanePosition& im = imaginary_planes.emplace_back();
    read(plane.normal, re.normal.data(), im.normal.data());
    re.offset = std::strtod(plane.offset.re.c_str(), nullptr);
    im.offset = std::strtod(plane.offset.im.c_str(), nullptr);
    is_real = is_real && plane.offset.im == "0";
  }
  if (is_real) return figure;
  figure.imaginary = std::move(imaginary);
  figure.imaginary_lines = std::move(imaginary_lines);
  figure.imaginary_planes = std::move(imaginary_planes);
  return figure;
}

DecimalFigure decimals_of(const Figure& figure) {
  DecimalFigure decimals;
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
    decimals.points.push_back(decimals_of(point_of(figure, i)));
  for (std::size_t i = 0; i < figure.lines.size(); ++i)
    decimals.lines.push_back({decimals_of(line_part(figure, i, &LinePosition::point)),
                              decimals_of(line_part(figure, i, &LinePosition::direction))});
  for (std::size_t i = 0; i < figure.planes.size(); ++i) {
    const std::complex<double> offset = offset_of(figure, i);
    decimals.planes.push_back(
        {decimals_of(normal_of(figure, i)), {decimal(offset.real()), decimal(offset.imag())}});
  }
  return decimals;
}

}  // namespace gcs
