#include "solvers/proven_paths/curve_section.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr int normal_bits = 10;

/// Of no coordinate in floating point: for a grid where there is nothing to be rounded.
constexpr double least_row = 0x1p-500;

/// The largest power of two that leaves m products of an entry and a component of ν, and differences of such
/// sums, within the 53 bits of a double.
double grid(double largest, Eigen::Index m) {
  const int spare = normal_bits + 2 + static_cast<int>(std::bit_width(static_cast<std::uint64_t>(m)));
  return std::ldexp(1.0, std::ilogb(largest) + 1 + spare - std::numeric_limits<double>::digits);
}

}  // namespace

bool set_section(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& tangent, bool has_exact_differences,
                 CurveSection& section) {
  const Eigen::Index m = jacobian.rows();
  Eigen::Index pivot = 0;
  tangent.cwiseAbs().maxCoeff(&pivot);
  const double unit = std::ldexp(1.0, normal_bits);
  const double sign = tangent[pivot] > 0 ? 1 : -1;
  section.normal =
      (tangent * (unit / std::abs(tangent[pivot]))).unaryExpr([](double x) { return std::round(x); }) / unit;
  section.jacobian = jacobian;

  Eigen::MatrixXd restricted(m, m);
  const auto place = [pivot](Eigen::Index j) { return j < pivot ? j : j + 1; };
  for (Eigen::Index j = 0; j < m; ++j)
    restricted.col(j) = jacobian.col(place(j)) - sign * section.normal[place(j)] * jacobian.col(pivot);
  const Eigen::MatrixXd inverse = restricted.partialPivLu().inverse();
  double largest = inverse.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  const auto is_rounded = [&](Eigen::Index j) {
    return has_exact_differences || section.normal[place(j)] != 0;
  };
  if (!has_exact_differences) {
    largest = least_row;
    for (Eigen::Index j = 0; j < m; ++j)
      if (is_rounded(j)) largest = std::max(largest, inverse.row(j).cwiseAbs().maxCoeff());
  }
  const double step = grid(largest, m);
  section.rows.setZero(m, m + 1);
  for (Eigen::Index j = 0; j < m; ++j) {
    if (!is_rounded(j)) {
      section.rows.col(place(j)) = inverse.row(j);
      continue;
    }
    section.rows.col(place(j)) =
        (inverse.row(j).transpose() / step).unaryExpr([](double x) { return std::round(x); }) * step;
    section.rows.col(pivot) -= sign * section.normal[place(j)] * section.rows.col(place(j));
  }
  return true;
}

}  // namespace gcs
