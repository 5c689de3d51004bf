#include "harness/tests/strategies/line_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
using WideVector = std::array<ComplexDoubleDouble, 3>;
using Vector6 = Eigen::Matrix<Complex, 6, 1>;

WideVector wide(const Eigen::Vector3cd& v) { return {widened(v[0]), widened(v[1]), widened(v[2])}; }

Eigen::Vector3cd narrow(const WideVector& v) { return {v[0].value(), v[1].value(), v[2].value()}; }

ComplexDoubleDouble product(const WideVector& a, const WideVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct WideCoordinates {
  WideVector point, direction;

  ComplexLine line() const { return {narrow(point), narrow(direction)}; }
  void subtract(const Vector6& change) {
    for (int i = 0; i < 3; ++i) {
      point[i] = point[i] - widened(change[i]);
      direction[i] = direction[i] - widened(change[3 + i]);
    }
  }
};

/// Of (w·w − (w·u)² − r²)/2, p·u and (u·u − 1)/2 with w = c − p.
Vector6 errors(const FourDistances& given, const WideCoordinates& at) {
  Vector6 result;
  for (int i = 0; i < 4; ++i) {
    WideVector w = wide(given.centers.col(i).cast<Complex>());
    for (int axis = 0; axis < 3; ++axis) w[axis] = w[axis] - at.point[axis];
    const ComplexDoubleDouble along = product(w, at.direction);
    const DoubleDouble square = two_product(given.lengths[i], given.lengths[i]);
    result[i] = (product(w, w) - along * along - square).value() / 2.0;
  }
  result[4] = product(at.point, at.direction).value();
  result[5] = (product(at.direction, at.direction) - DoubleDouble{1, 0}).value() / 2.0;
  return result;
}

using WideRow = std::array<ComplexDoubleDouble, 7>;

/// The linear system of a Newton step, its right side last. Columns: point, direction.
std::array<WideRow, 6> newton_system(const FourDistances& given, const WideCoordinates& at) {
  const Vector6 right = errors(given, at);
  std::array<WideRow, 6> rows{};
  for (std::size_t i = 0; i < 6; ++i) rows[i][6] = widened(right[static_cast<Eigen::Index>(i)]);
  for (std::size_t i = 0; i < 4; ++i) {
    WideVector w = wide(given.centers.col(static_cast<Eigen::Index>(i)).cast<Complex>());
    for (std::size_t axis = 0; axis < 3; ++axis) w[axis] = w[axis] - at.point[axis];
    const ComplexDoubleDouble along = product(w, at.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[i][axis] = along * at.direction[axis] - w[axis];
      rows[i][axis + 3] = ComplexDoubleDouble{} - along * w[axis];
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[4][axis] = rows[5][axis + 3] = at.direction[axis];
    rows[4][axis + 3] = at.point[axis];
  }
  return rows;
}

ComplexDoubleDouble quotient(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  const DoubleDouble square = b.re * b.re + b.im * b.im;
  const ComplexDoubleDouble product = a * ComplexDoubleDouble{b.re, -b.im};
  return {product.re / square, product.im / square};
}

/// Gauss–Jordan elimination with row pivots.
Vector6 solution_of(std::array<WideRow, 6> rows) {
  for (std::size_t k = 0; k < 6; ++k) {
    const auto size = [k](const WideRow& row) { return std::abs(row[k].value()); };
    std::swap(rows[k],
              *std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                [&](const WideRow& a, const WideRow& b) { return size(a) < size(b); }));
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == k) continue;
      const ComplexDoubleDouble factor = quotient(rows[i][k], rows[k][k]);
      for (std::size_t j = k; j < 7; ++j) rows[i][j] = rows[i][j] - factor * rows[k][j];
    }
  }
  Vector6 result;
  for (std::size_t k = 0; k < 6; ++k)
    result[static_cast<Eigen::Index>(k)] = quotient(rows[k][6], rows[k][k]).value();
  return result;
}

/// |d² − r²|/(|d + r| r)
double relative(Complex excess, double length) {
  return std::abs(excess) / (std::abs(std::sqrt(excess + length * length) + length) * length);
}

/// E of the header.
double squared_distance_error(const ComplexLine& line, const Eigen::Vector3d& center) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2;
  const Eigen::Vector3cd c = center.cast<Complex>();
  const Complex a = bilinear_product(c, line.direction);
  const Eigen::Array3d n = (c - line.point - a * line.direction).cwiseAbs();
  const Eigen::Array3d u = line.direction.cwiseAbs();
  const Eigen::Array3d e = epsilon * (line.point.cwiseAbs().array() + std::abs(a) * u);
  const double k = (epsilon * n * u + (1 + epsilon) * e * u).sum();
  return 2 * (n * e).sum() + e.square().sum() + k * k / (1 - 3 * epsilon * u.square().sum());
}

}  // namespace

double residual_of_rounding(const FourDistances& given, const ComplexLine& line) {
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    const double length = given.lengths[i];
    const double error = squared_distance_error(line, given.centers.col(i));
    const double other = std::sqrt(std::max(0.0, length * length - error));
    worst = std::max(worst, error / (length * (length + other)));
  }
  return worst;
}

WideLine refined_in_double_double(const FourDistances& given, const ComplexLine& line) {
  constexpr int iterations = 6;  // each squares the error, from 1e-4 at worst
  WideCoordinates at{wide(line.point), wide(line.direction)};
  for (int i = 0; i < iterations; ++i) at.subtract(solution_of(newton_system(given, at)));
  WideLine result;
  const Vector6 left = errors(given, at);
  for (int i = 0; i < 4; ++i)
    result.residual = std::max(result.residual, relative(2.0 * left[i], given.lengths[i]));
  const ComplexLine now = at.line();
  result.moved = std::max((now.point - line.point).norm() / (1 + line.point.norm()),
                          (now.direction - line.direction).norm() / line.direction.norm());
  return result;
}

}  // namespace gcs
