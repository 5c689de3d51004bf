#pragma once
/// Complex numbers in lanes. The standard's would take care of infinities in every product. They are copied
/// part by part: compilers copy larger objects in pieces that are shorter than a vector, and a vector that is
/// loaded soon after waits for all of them.

#include <complex>

#include "solvers/lanes/lanes.hpp"

namespace gcs::GCS_LANES {

template <class Real>
struct Complex {
  Real re;
  Real im;

  Complex() = default;
  Complex(Real real, Real imaginary) : re(real), im(imaginary) {}
  Complex(const Complex& other) : re(other.re), im(other.im) {}
  Complex& operator=(const Complex& other) {
    re = other.re;
    im = other.im;
    return *this;
  }
};

template <class Real>
Complex<Real> operator+(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <class Real>
Complex<Real> operator-(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <class Real>
Complex<Real> operator-(const Complex<Real>& a) {
  return {-a.re, -a.im};
}
template <class Real>
Complex<Real> operator*(Real a, const Complex<Real>& b) {
  return {a * b.re, a * b.im};
}
template <class Real>
Complex<Real> fused(Real a, const Complex<Real>& b, const Complex<Real>& c) {
  return {fused(a, b.re, c.re), fused(a, b.im, c.im)};
}
/// c + a·b
template <class Real>
Complex<Real> fused(const Complex<Real>& a, const Complex<Real>& b, const Complex<Real>& c) {
  return {fused_minus(a.im, b.im, fused(a.re, b.re, c.re)), fused(a.im, b.re, fused(a.re, b.im, c.im))};
}
/// c − a·b
template <class Real>
Complex<Real> fused_minus(const Complex<Real>& a, const Complex<Real>& b, const Complex<Real>& c) {
  return {fused(a.im, b.im, fused_minus(a.re, b.re, c.re)),
          fused_minus(a.im, b.re, fused_minus(a.re, b.im, c.im))};
}
template <class Real>
Complex<Real> inverse(const Complex<Real>& a) {
  const Real square = fused(a.re, a.re, a.im * a.im);
  return {a.re / square, -a.im / square};
}
template <class Real>
Complex<Real> product(const Complex<Real>& a, const Complex<Real>& b) {
  return {fused_minus(a.im, b.im, a.re * b.re), fused(a.im, b.re, a.re * b.im)};
}
/// The larger of |re| and |im|.
template <class Real>
Real size_of(const Complex<Real>& a) {
  return larger(absolute(a.re), absolute(a.im));
}
template <class Real>
Complex<Real> selected(Real mask, const Complex<Real>& a, const Complex<Real>& b) {
  return {selected(mask, a.re, b.re), selected(mask, a.im, b.im)};
}

/// Adds a·b to re + i·im.
template <class Real>
void add_product(const Complex<Real>& a, const Complex<Real>& b, Compensated<Real>& re,
                 Compensated<Real>& im) {
  re.add_product(a.re, b.re);
  re.add_product(-a.im, b.im);
  im.add_product(a.re, b.im);
  im.add_product(a.im, b.re);
}

/// A sum of products in four parts that do not wait for each other, where latency would set the pace.
template <class Real>
struct SplitSum {
  Real re_re{}, im_im{}, re_im{}, im_re{};

  void add_product(const Complex<Real>& a, const Complex<Real>& b) {
    re_re = fused(a.re, b.re, re_re);
    im_im = fused(a.im, b.im, im_im);
    re_im = fused(a.re, b.im, re_im);
    im_re = fused(a.im, b.re, im_re);
  }
  Complex<Real> value() const { return {re_re - im_im, re_im + im_re}; }
};

/// The same in all lanes.
template <class Real>
Complex<Real> number(std::complex<double> z, Real) {
  return {constant(z.real(), Real{}), constant(z.imag(), Real{})};
}
template <class Real>
void set(Complex<Real>& value, int lane, std::complex<double> z) {
  value.re.set_lane(lane, z.real());
  value.im.set_lane(lane, z.imag());
}

}  // namespace gcs::GCS_LANES
