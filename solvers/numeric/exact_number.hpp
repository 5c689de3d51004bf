#pragma once
/// Numbers that are known exactly, however many digits they have, for proofs about a file's own numbers and
/// not about their nearest doubles.

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace gcs {

/// base·2^exponent, squared if so marked, with its sign changed if so marked; the base is a decimal number as
/// a file writes it or, where there is none, a double, or the cosine of so many degrees; divided by the norm of other
/// numbers, where there are some. By default 0.
struct ExactNumber {
  std::string decimal{};
  std::complex<double> value = 0;
  int exponent = 0;
  bool is_squared = false;
  bool is_negative = false;
  std::vector<ExactNumber> divided_by_norm_of{};
  bool is_cosine_of_degrees = false;  ///< and then `value` is the nearest double to the number of degrees

  bool is_zero() const { return decimal.empty() && value == 0.0 && !is_cosine_of_degrees; }
};

/// A double.
inline ExactNumber exactly(std::complex<double> value) {
  ExactNumber number;
  number.value = value;
  return number;
}

/// In doubles, to a few roundings. Precondition: `value` is the nearest double to `decimal`.
inline std::complex<double> rounded_to_double(const ExactNumber& number) {
  std::complex<double> base = number.value;
  if (number.is_cosine_of_degrees) base = std::cos(base.real() * (std::numbers::pi / 180));
  base = {std::ldexp(base.real(), number.exponent), std::ldexp(base.imag(), number.exponent)};
  if (number.is_squared) base *= base;
  double norm = 0;
  for (const ExactNumber& part : number.divided_by_norm_of) norm = std::hypot(norm, part.value.real());
  if (norm > 0) base /= norm;
  return number.is_negative ? -base : base;
}

inline ExactNumber negated(ExactNumber number) {
  number.is_negative = !number.is_negative;
  return number;
}

}  // namespace gcs
