#pragma once
/// Numbers of about 106 bits as unevaluated sums of two doubles (Dekker 1971; error-free transformations).
/// Used where a residual must be known better than the point at which it is taken.

#include <cmath>

namespace gcs {

/// hi + lo with |lo| ≤ ulp(hi)/2. Overflow and underflow behave as for doubles.
struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  double value() const { return hi + lo; }
};

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a · b exactly unless the low part underflows.
inline DoubleDouble two_product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  const DoubleDouble t = two_sum(a.lo, b.lo);
  const DoubleDouble u = two_sum(s.hi, s.lo + t.hi);
  return two_sum(u.hi, u.lo + t.lo);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble p = two_product(a.hi, b.hi);
  return two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// The quotient by two corrections of the double one.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = a - b * DoubleDouble{first, 0};
  const double second = rest.hi / b.hi;
  const DoubleDouble last = rest - b * DoubleDouble{second, 0};
  return two_sum(first, second) + DoubleDouble{last.hi / b.hi, 0};
}

/// Square root by one Newton step from the double one. Precondition: a ≥ 0.
inline DoubleDouble sqrt(DoubleDouble a) {
  const double root = std::sqrt(a.hi);
  if (root == 0) return {};
  const DoubleDouble rest = a - two_product(root, root);
  return two_sum(root, rest.hi / (2 * root));
}

/// |a − b|² of two points given in doubles; `a` and `b` need operator[] and `dimension` components.
template <class Vector>
DoubleDouble squared_distance(const Vector& a, const Vector& b, int dimension) {
  DoubleDouble sum;
  for (int axis = 0; axis < dimension; ++axis) {
    const DoubleDouble difference = two_sum(a[axis], -b[axis]);
    sum = sum + difference * difference;
  }
  return sum;
}

}  // namespace gcs
