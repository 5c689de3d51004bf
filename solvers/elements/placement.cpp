#include "solvers/elements/placement.hpp"

#include <cmath>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

std::vector<ComplexPlane> complex_planes(const Figure& figure) {
  std::vector<ComplexPlane> planes;
  for (std::size_t i = 0; i < figure.planes.size(); ++i) {
    ComplexPlane plane{figure.planes[i].normal.cast<std::complex<double>>(), figure.planes[i].offset};
    if (i < figure.imaginary_planes.size()) {
      plane.normal.imag() = figure.imaginary_planes[i].normal;
      plane.offset = {figure.planes[i].offset, figure.imaginary_planes[i].offset};
    }
    planes.push_back(plane);
  }
  return planes;
}

/// The side that lines would have: the direction of the normalised line along the normal.
ComplexPlane with_first_positive(const ComplexPlane& plane) {
  const ComplexLine line = normalised(ComplexLine{Eigen::Vector3cd::Zero(), plane.normal});
  const double agreement = (line.direction + plane.normal).norm() - (line.direction - plane.normal).norm();
  return agreement < 0 ? ComplexPlane{-plane.normal, -plane.offset} : plane;
}

}  // namespace

ComplexPlane normalised(const ComplexPlane& plane) {
  constexpr double rounding = 4 * epsilon;
  const double largest = plane.normal.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return plane;
  const Eigen::Vector3cd direction = plane.normal / largest;  // whose square neither overflows nor vanishes
  const std::complex<double> length = std::sqrt(bilinear_product(direction, direction));
  if (length == 0.0 || std::abs(largest * length - 1.0) <= rounding) return plane;
  return {direction / length, plane.offset / largest / length};
}

Placement placement_of(const Figure& figure) {
  return {complex_points(figure), normalised(complex_lines(figure)), complex_planes(figure)};
}

Figure figure_of(const Placement& placement, bool is_real, const std::vector<bool>& turned) {
  Figure figure = figure_of(placement.points, placement.lines, is_real);
  for (std::size_t i = 0; i < placement.planes.size(); ++i) {
    const ComplexPlane plane = turned[i] ? with_first_positive(placement.planes[i]) : placement.planes[i];
    figure.planes.push_back({plane.normal.real(), plane.offset.real()});
    if (!is_real) figure.imaginary_planes.push_back({plane.normal.imag(), plane.offset.imag()});
  }
  return figure;
}

}  // namespace gcs
