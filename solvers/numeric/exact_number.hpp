#pragma once
/// Numbers that are known exactly, however many digits they have, for proofs about a file's own numbers and
/// not about their nearest doubles.

#include <complex>
#include <string>

namespace gcs {

/// base·2^exponent, squared if so marked, with its sign changed if so marked; the base is a decimal number as
/// a file writes it or, where there is none, a double. By default 0.
struct ExactNumber {
  std::string decimal{};
  std::complex<double> value = 0;
  int exponent = 0;
  bool is_squared = false;
  bool is_negative = false;

  bool is_zero() const { return decimal.empty() && value == 0.0; }
};

/// A double.
inline ExactNumber exactly(std::complex<double> value) {
  ExactNumber number;
  number.value = value;
  return number;
}

inline ExactNumber negated(ExactNumber number) {
  number.is_negative = !number.is_negative;
  return number;
}

}  // namespace gcs
