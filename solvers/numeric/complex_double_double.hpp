#pragma once
/// Complex numbers in double-double, and a common way to the wide type of a real or complex scalar.

#include <complex>

#include "solvers/numeric/double_double.hpp"

namespace gcs {

struct ComplexDoubleDouble {
  DoubleDouble re;
  DoubleDouble im;

  std::complex<double> value() const { return {re.value(), im.value()}; }
};

inline ComplexDoubleDouble operator+(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re + b.re, a.im + b.im};
}

inline ComplexDoubleDouble operator-(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re - b.re, a.im - b.im};
}

inline ComplexDoubleDouble operator-(const ComplexDoubleDouble& a, DoubleDouble b) {
  return {a.re - b, a.im};
}

inline ComplexDoubleDouble operator*(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

inline ComplexDoubleDouble operator*(DoubleDouble a, const ComplexDoubleDouble& b) {
  return {a * b.re, a * b.im};
}

/// 1/√a, the root with Re √a ≥ 0, by one Newton step from the double one. Precondition: a ≠ 0.
inline ComplexDoubleDouble inverse_sqrt(const ComplexDoubleDouble& a) {
  const std::complex<double> start = 1.0 / std::sqrt(a.value());
  const ComplexDoubleDouble first{{start.real(), 0}, {start.imag(), 0}};
  const std::complex<double> rest = (a * first * first - DoubleDouble{1, 0}).value();
  const std::complex<double> change = start * rest / 2.0;
  return first - ComplexDoubleDouble{{change.real(), 0}, {change.imag(), 0}};
}

/// a − b exactly.
inline DoubleDouble wide_difference(double a, double b) { return two_sum(a, -b); }
inline ComplexDoubleDouble wide_difference(const std::complex<double>& a, const std::complex<double>& b) {
  return {two_sum(a.real(), -b.real()), two_sum(a.imag(), -b.imag())};
}

/// The number itself in the wide type.
inline DoubleDouble widened(double a) { return {a, 0}; }
inline ComplexDoubleDouble widened(const std::complex<double>& a) { return {{a.real(), 0}, {a.imag(), 0}}; }

}  // namespace gcs
