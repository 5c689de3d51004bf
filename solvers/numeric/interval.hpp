#pragma once
/// Closed intervals of doubles whose operations enclose all results: rounded outwards by a unit in the last
/// place or two, without changing the rounding mode. (Moore, Interval analysis, 1966.)

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/numeric/double_double.hpp"

namespace gcs {

/// A double below x by at least the rounding error of an operation that gave x: |x|·2^-53, or what underflows.
inline double rounded_down(double x) { return x - (std::abs(x) * 0x1p-52 + 0x1p-1070); }
inline double rounded_up(double x) { return x + (std::abs(x) * 0x1p-52 + 0x1p-1070); }

/// All x with low ≤ x ≤ high; none where low > high. Not a number in place of an end means that nothing is
/// known.
struct Interval {
  double low = 0;
  double high = 0;

  bool is_empty() const { return low > high; }
  bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
  bool contains(double x) const { return low <= x && x <= high; }
  bool contains_zero() const { return contains(0); }
  double width() const { return high - low; }
  /// Some double in it.
  double middle() const { return std::clamp(low / 2 + high / 2, low, high); }
  /// At least |x| for all of its x.
  double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
  /// At least |x − middle| for all of its x.
  double reach(double middle) const { return rounded_up(std::max(high - middle, middle - low)); }
};

/// The number x.
inline Interval exact_interval(double x) { return {x, x}; }
/// All x with |x| ≤ radius.
inline Interval interval_around_zero(double radius) { return {-radius, radius}; }
/// Encloses a number that is known to 2^-100, relative to it.
inline Interval enclosing(const DoubleDouble& x) {
  const double value = x.value();
  return {rounded_down(value), rounded_up(value)};
}

inline Interval operator-(const Interval& x) { return {-x.high, -x.low}; }
inline Interval operator+(const Interval& x, const Interval& y) {
  return {rounded_down(x.low + y.low), rounded_up(x.high + y.high)};
}
inline Interval operator-(const Interval& x, const Interval& y) { return x + -y; }
inline Interval operator*(const Interval& x, const Interval& y) {
  const double a = x.low * y.low, b = x.low * y.high, c = x.high * y.low, d = x.high * y.high;
  return {rounded_down(std::min({a, b, c, d})), rounded_up(std::max({a, b, c, d}))};
}
inline Interval operator*(double x, const Interval& y) {
  const double a = x * y.low, b = x * y.high;
  return {rounded_down(std::min(a, b)), rounded_up(std::max(a, b))};
}
/// Precondition: y does not contain 0.
inline Interval operator/(const Interval& x, const Interval& y) {
  const double a = x.low / y.low, b = x.low / y.high, c = x.high / y.low, d = x.high / y.high;
  return {rounded_down(std::min({a, b, c, d})), rounded_up(std::max({a, b, c, d}))};
}
inline Interval square(const Interval& x) {
  const double a = x.low * x.low, b = x.high * x.high;
  if (x.low <= 0 && x.high >= 0) return {0, rounded_up(std::max(a, b))};
  return {std::max(0.0, rounded_down(std::min(a, b))), rounded_up(std::max(a, b))};
}
/// The roots of those of its numbers that are not negative. Precondition: high ≥ 0.
inline Interval sqrt(const Interval& x) {
  const double low = std::sqrt(std::max(0.0, x.low));
  return {std::max(0.0, rounded_down(low)), rounded_up(std::sqrt(x.high))};
}
inline Interval intersection(const Interval& x, const Interval& y) {
  return {std::max(x.low, y.low), std::min(x.high, y.high)};
}

}  // namespace gcs
