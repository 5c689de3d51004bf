#include "solvers/model/complex_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/wide_vector.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

ComplexDoubleDouble square_of(const WideVector& v) { return bilinear_product(v, v); }

/// False for the one of u and −u that represents both.
bool is_to_be_turned(const Eigen::Vector3cd& u) {
  const double zero = 1e-9 * u.cwiseAbs().maxCoeff();
  int lead = 0;
  while (lead < 2 && std::abs(u[lead]) <= zero) ++lead;
  return std::abs(u[lead].real()) > zero ? u[lead].real() < 0 : u[lead].imag() < 0;
}

/// Rounding every coordinate moves direction·direction and point·direction by an epsilon of these sizes at
/// most, and evaluating them in doubles by as much again.
bool is_normalised_but_for_its_sign(const ComplexLine& line) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const Eigen::Vector3cd& u = line.direction;
  return std::abs(bilinear_product(u, u) - 1.0) <= rounding * u.squaredNorm() &&
         std::abs(bilinear_product(u, line.point)) <= rounding * u.norm() * line.point.norm();
}

}  // namespace

std::vector<ComplexLine> complex_lines(const Figure& figure) {
  std::vector<ComplexLine> lines;
  for (const LinePosition& line : figure.lines)
    lines.push_back({line.point.cast<Complex>(), line.direction.cast<Complex>()});
  for (std::size_t i = 0; i < figure.imaginary_lines.size(); ++i) {
    lines[i].point.imag() = figure.imaginary_lines[i].point;
    lines[i].direction.imag() = figure.imaginary_lines[i].direction;
  }
  return lines;
}

void set_complex_lines(const std::vector<ComplexLine>& lines, Figure& figure) {
  figure.lines.clear();
  figure.imaginary_lines.clear();
  for (const ComplexLine& line : lines) {
    figure.lines.push_back({line.point.real(), line.direction.real()});
    figure.imaginary_lines.push_back({line.point.imag(), line.direction.imag()});
  }
}

Figure figure_of(const ComplexPoints& points, const std::vector<ComplexLine>& lines, bool is_real) {
  Figure figure = complex_figure(points);
  set_complex_lines(lines, figure);
  if (!is_real) return figure;
  figure.imaginary.resize(3, 0);
  figure.imaginary_lines.clear();
  return figure;
}

ComplexLine normalised(const ComplexLine& line) {
  ComplexLine result = line;
  if (!is_normalised_but_for_its_sign(line)) {
    result.direction /= std::sqrt(bilinear_product(line.direction, line.direction));
    result.point -= result.direction * bilinear_product(result.direction, line.point);
  }
  if (is_to_be_turned(result.direction)) result.direction = -result.direction;
  return result;
}

std::vector<ComplexLine> normalised(std::vector<ComplexLine> lines) {
  for (ComplexLine& line : lines) line = normalised(line);
  return lines;
}

Eigen::Vector3cd foot(const ComplexLine& line, const Eigen::Vector3cd& point) {
  const Complex along = bilinear_product(line.direction, Eigen::Vector3cd(point - line.point));
  return line.point + line.direction * (along / bilinear_product(line.direction, line.direction));
}

Figure moved_to_line(const Figure& figure, int line, int height) {
  std::vector<ComplexLine> lines = complex_lines(figure);
  ComplexPoints points = complex_points(figure);
  const Eigen::Vector3cd origin = foot(lines[line], points.col(height));
  Eigen::Matrix3cd axes;
  axes.row(0) = normalised(lines[line]).direction.transpose();
  const Eigen::Vector3cd up = points.col(height) - origin;
  axes.row(2) = up.transpose() / std::sqrt(bilinear_product(up, up));
  axes.row(1) = cross_product(axes.row(2).transpose(), axes.row(0).transpose()).transpose();
  points = axes * (points.colwise() - origin);
  points.col(height).head<2>().setZero();
  for (ComplexLine& other : lines) other = {axes * (other.point - origin), axes * other.direction};
  lines[line] = {Eigen::Vector3cd::Zero(), Eigen::Vector3cd::UnitX()};
  Figure result = complex_figure(points);
  set_complex_lines(lines, result);
  return result;
}

Complex squared_distance_excess(const Eigen::Vector3cd& point, const ComplexLine& line, DoubleDouble square) {
  const WideVector w = wide_difference(point, line.point), u = widened(line.direction);
  const ComplexDoubleDouble uu = square_of(u);
  const ComplexDoubleDouble scaled_square = uu * ComplexDoubleDouble{square, {}};
  return (square_of(cross_product(w, u)) - scaled_square).value() / uu.value();
}

}  // namespace gcs
