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

/// a − b exactly.
inline DoubleDouble wide_difference(double a, double b) { return two_sum(a, -b); }
inline ComplexDoubleDouble wide_difference(const std::complex<double>& a, const std::complex<double>& b) {
  return {two_sum(a.real(), -b.real()), two_sum(a.imag(), -b.imag())};
}

/// The number itself in the wide type.
inline DoubleDouble widened(double a) { return {a, 0}; }
inline ComplexDoubleDouble widened(const std::complex<double>& a) { return {{a.real(), 0}, {a.imag(), 0}}; }

}  // namespace gcs
