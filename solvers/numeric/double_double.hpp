#pragma once
/// Numbers of about 106 bits as unevaluated sums of two doubles (Dekker 1971; error-free transformations).
/// Used where a residual must be known better than the point at which it is taken.

#include <cmath>

namespace gcs {

/// hi + lo with |lo| ≤ ulp(hi)/2; of doubles side by side for each of them. Overflow and underflow behave as for doubles.
/// Operations are inlined always: arguments of two vectors of doubles would be passed in memory.
template <class Real>
struct Doubled {
  Real hi = {};
  Real lo = {};

  Real value() const { return hi + lo; }
};

using DoubleDouble = Doubled<double>;

/// a·b + c with one rounding.
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }

/// a + b exactly.
template <class Real>
[[gnu::always_inline]] inline Doubled<Real> two_sum(Real a, Real b) {
  const Real s = a + b;
  const Real t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a · b exactly unless the low part underflows.
template <class Real>
[[gnu::always_inline]] inline Doubled<Real> two_product(Real a, Real b) {
  const Real p = a * b;
  return {p, fused(a, b, -p)};
}

template <class Real>
[[gnu::always_inline]] inline Doubled<Real> operator-(Doubled<Real> a) {
  return {-a.hi, -a.lo};
}

template <class Real>
[[gnu::always_inline]] inline Doubled<Real> operator+(Doubled<Real> a, Doubled<Real> b) {
  const Doubled<Real> s = two_sum(a.hi, b.hi);
  const Doubled<Real> t = two_sum(a.lo, b.lo);
  const Doubled<Real> u = two_sum<Real>(s.hi, s.lo + t.hi);
  return two_sum<Real>(u.hi, u.lo + t.lo);
}

template <class Real>
[[gnu::always_inline]] inline Doubled<Real> operator-(Doubled<Real> a, Doubled<Real> b) {
  return a + -b;
}

template <class Real>
[[gnu::always_inline]] inline Doubled<Real> operator*(Doubled<Real> a, Doubled<Real> b) {
  const Doubled<Real> p = two_product(a.hi, b.hi);
  return two_sum<Real>(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// The quotient by two corrections of the double one.
template <class Real>
[[gnu::always_inline]] inline Doubled<Real> operator/(Doubled<Real> a, Doubled<Real> b) {
  const Real first = a.hi / b.hi;
  const Doubled<Real> rest = a - b * Doubled<Real>{first, {}};
  const Real second = rest.hi / b.hi;
  const Doubled<Real> last = rest - b * Doubled<Real>{second, {}};
  return two_sum(first, second) + Doubled<Real>{last.hi / b.hi, {}};
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
