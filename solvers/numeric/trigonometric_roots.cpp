#include "solvers/numeric/trigonometric_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solvers/numeric/polynomial_roots.hpp"

namespace gcs {
namespace {

/// Coefficients in ascending order.
using Quartic = std::array<double, 5>;

/// f·(1 + t²)² with t = tan(φ/2).
Quartic in_half_angle(const TwoHarmonics& f) {
  return {f.constant + f.cos1 + f.cos2, 2 * f.sin1 + 4 * f.sin2, 2 * f.constant - 6 * f.cos2,
          2 * f.sin1 - 4 * f.sin2, f.constant - f.cos1 + f.cos2};
}

/// q(−t).
Quartic mirrored(Quartic q) {
  q[1] = -q[1];
  q[3] = -q[3];
  return q;
}

/// t⁴·q(1/t).
Quartic reversed(Quartic q) {
  std::reverse(q.begin(), q.end());
  return q;
}

/// q(1) by two sums, of which each range of t that ends there uses one: where they differ in sign each may
/// leave the zero to the other.
bool vanishes_at_one(const Quartic& q) {
  return (polynomial_value(q, 1) < 0) != (polynomial_value(reversed(q), 1) < 0);
}

/// In ascending order, each once. Neighbouring ranges of t share an end, where a zero is found twice to
/// rounding; the resolution of real_roots is four times 1e-12.
void keep_distinct(std::vector<double>& angles) {
  constexpr double resolution = 1e-11;
  std::sort(angles.begin(), angles.end());
  const auto close = [](double a, double b) { return b - a < resolution; };
  angles.erase(std::unique(angles.begin(), angles.end(), close), angles.end());
  const bool wraps = angles.size() > 1 && angles.front() + 2 * std::numbers::pi - angles.back() < resolution;
  if (wraps) angles.erase(angles.begin());
}

}  // namespace

std::vector<double> real_zeros(const TwoHarmonics& f) {
  const Quartic q = in_half_angle(f);
  if (std::all_of(q.begin(), q.end(), [](double c) { return c == 0; })) return {};
  std::vector<double> angles;
  if (q.front() == 0) angles.push_back(0);
  if (q.back() == 0) angles.push_back(std::numbers::pi);
  for (const double side : {1.0, -1.0}) {
    const Quartic of_side = side > 0 ? q : mirrored(q);
    if (vanishes_at_one(of_side)) angles.push_back(side * std::numbers::pi / 2);
    for (const double t : real_roots(of_side, 1)) angles.push_back(side * 2 * std::atan(t));
    for (const double s : real_roots(reversed(of_side), 1)) angles.push_back(side * 2 * std::atan2(1, s));
  }
  keep_distinct(angles);
  return angles;
}

}  // namespace gcs
