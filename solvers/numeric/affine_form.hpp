#pragma once
/// Enclosures of functions over a cell of parameters: affine forms with one symbol for each parameter and a
/// remainder (Stolfi, de Figueiredo, Self-validated numerical methods, 1997, chapter 3). Quantities that
/// depend on the same parameters stay correlated, and the remainder falls with the square of the cell's
/// width.
///
/// Rounding is enclosed: every operation adds more than its rounding errors to the remainder, which
/// `underflow` lifts above anything lost below the smallest normal number.

#include <algorithm>
#include <array>
#include <cmath>

namespace gcs {

/// All values mid + Σ slope_i ξ_i + e with |ξ_i| ≤ 1, |e| ≤ rest.
template <int N>
struct AffineForm {
  double mid = 0;
  std::array<double, N> slope{};
  double rest = 0;

  AffineForm() = default;
  AffineForm(double value) : mid(value) {}  // NOLINT(google-explicit-constructor): a number is a form

  /// Σ |slope_i|: how far the linear part reaches.
  double reach() const {
    double sum = 0;
    for (const double s : slope) sum += std::abs(s);
    return sum;
  }
  double radius() const { return (reach() + rest) * (1 + 8 * epsilon); }
  double low() const { return mid - radius() - 2 * epsilon * std::abs(mid); }
  double high() const { return mid + radius() + 2 * epsilon * std::abs(mid); }
  bool contains_zero() const { return !(low() > 0) && !(high() < 0); }
  bool is_finite() const { return std::isfinite(mid) && std::isfinite(radius()); }

  static constexpr double epsilon = 0x1p-52;
  static constexpr double underflow = 0x1p-1000;
};

/// c·x + d, where c and d are known to `error` in all (at |ξ| ≤ 1) beyond rounding.
template <int N>
AffineForm<N> scaled_and_shifted(const AffineForm<N>& x, double c, double d, double error) {
  using Form = AffineForm<N>;
  Form result;
  result.mid = c * x.mid + d;
  for (int i = 0; i < N; ++i) result.slope[i] = c * x.slope[i];
  const double rounding = std::abs(c * x.mid) + std::abs(d) + std::abs(c) * x.reach();
  result.rest = (std::abs(c) * x.rest + error + 4 * Form::epsilon * rounding) * (1 + 8 * Form::epsilon) +
                Form::underflow;
  return result;
}

template <int N>
AffineForm<N> operator*(double c, const AffineForm<N>& x) {
  return scaled_and_shifted(x, c, 0, 0);
}

template <int N>
AffineForm<N> operator+(const AffineForm<N>& x, double d) {
  return scaled_and_shifted(x, 1, d, 0);
}

template <int N>
AffineForm<N> operator-(const AffineForm<N>& x) {
  AffineForm<N> result = x;
  result.mid = -result.mid;
  for (double& s : result.slope) s = -s;
  return result;
}

template <int N>
AffineForm<N> operator+(const AffineForm<N>& x, const AffineForm<N>& y) {
  using Form = AffineForm<N>;
  Form sum;
  sum.mid = x.mid + y.mid;
  double rounding = std::abs(sum.mid);
  for (int i = 0; i < N; ++i) {
    sum.slope[i] = x.slope[i] + y.slope[i];
    rounding += std::abs(sum.slope[i]);
  }
  sum.rest = (x.rest + y.rest + Form::epsilon * rounding) * (1 + 8 * Form::epsilon) + Form::underflow;
  return sum;
}

template <int N>
AffineForm<N> operator-(const AffineForm<N>& x, const AffineForm<N>& y) {
  return x + -y;
}

template <int N>
AffineForm<N> operator*(const AffineForm<N>& x, const AffineForm<N>& y) {
  using Form = AffineForm<N>;
  const double x_reach = x.reach();
  const double y_reach = y.reach();
  Form product;
  product.mid = x.mid * y.mid;
  for (int i = 0; i < N; ++i) product.slope[i] = x.mid * y.slope[i] + y.mid * x.slope[i];
  const double x_size = std::abs(x.mid) + x_reach;
  const double y_size = std::abs(y.mid) + y_reach;
  product.rest = (x_reach * y_reach + x.rest * y_size + y.rest * (x_size + x.rest) +
                  4 * Form::epsilon * x_size * y_size) *
                     (1 + 16 * Form::epsilon) +
                 Form::underflow;
  return product;
}

/// x², which knows that a square of the linear part is not negative.
template <int N>
AffineForm<N> square(const AffineForm<N>& x) {
  using Form = AffineForm<N>;
  const double reach = x.reach();
  const double size = std::abs(x.mid) + reach;
  const double half = reach * reach / 2;
  Form result;
  result.mid = x.mid * x.mid + half;
  for (int i = 0; i < N; ++i) result.slope[i] = 2 * x.mid * x.slope[i];
  result.rest =
      (half + x.rest * (2 * size + x.rest) + 8 * Form::epsilon * size * size) * (1 + 16 * Form::epsilon) +
      Form::underflow;
  return result;
}

/// The square root of what of x is not negative: the chord between the ends and how far the root leaves it.
/// Precondition: x.high() > 0.
template <int N>
AffineForm<N> sqrt(const AffineForm<N>& x) {
  const double low = std::sqrt(std::max(0.0, x.low()));
  const double high = std::sqrt(x.high());
  const double slope = 1 / (low + high);
  const double top = (low + high) / 4;    // of √x − slope·x, inside
  const double end = low * high * slope;  // of the same at both ends
  return scaled_and_shifted(x, slope, (top + end) / 2, (top - end) / 2 + 8 * AffineForm<N>::epsilon * high);
}

/// Whether 1/x is bounded, and doubles hold its slope.
template <int N>
bool has_reciprocal(const AffineForm<N>& x) {
  return x.low() > 0 && std::isfinite(1 / (x.low() * x.high()));
}

/// 1/x by its chord. Precondition: has_reciprocal(x).
template <int N>
AffineForm<N> reciprocal(const AffineForm<N>& x) {
  const double low = x.low();
  const double high = x.high();
  const double end = 1 / low + 1 / high;  // of 1/x + x/(low·high) at both ends
  const double least = 2 / std::sqrt(low * high);
  return scaled_and_shifted(x, -1 / (low * high), (end + least) / 2,
                            (end - least) / 2 + 8 * AffineForm<N>::epsilon * end);
}

template <int N>
struct CosineAndSine {
  AffineForm<N> cosine;
  AffineForm<N> sine;
};

/// By their tangents at x.mid. The library's cosine and sine are taken to be right to four units in the last
/// place of 1.
template <int N>
CosineAndSine<N> cosine_and_sine(const AffineForm<N>& x) {
  AffineForm<N> step = x;
  step.mid = 0;
  const double c = std::cos(x.mid);
  const double s = std::sin(x.mid);
  const double error = step.radius() * step.radius() / 2 + 4 * AffineForm<N>::epsilon;
  return {scaled_and_shifted(step, -s, c, error), scaled_and_shifted(step, c, s, error)};
}

template <int N>
using FormVector = std::array<AffineForm<N>, 3>;

template <int N>
FormVector<N> operator+(const FormVector<N>& a, const FormVector<N>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <int N>
FormVector<N> operator-(const FormVector<N>& a, const FormVector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <int N>
FormVector<N> operator*(const AffineForm<N>& s, const FormVector<N>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

template <int N>
AffineForm<N> dot(const FormVector<N>& a, const FormVector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <int N>
AffineForm<N> square(const FormVector<N>& a) {
  return square(a[0]) + square(a[1]) + square(a[2]);
}

template <int N>
FormVector<N> cross(const FormVector<N>& a, const FormVector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace gcs
