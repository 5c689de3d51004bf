#pragma once
/// Real numbers of a hundred digits, for making lengths.

#include <arb.h>

#include <string>

namespace gcs {

class LongDecimal {
 public:
  LongDecimal(const std::string& decimal) : LongDecimal() { arb_set_str(value_, decimal.c_str(), bits); }
  LongDecimal(const char* decimal) : LongDecimal(std::string(decimal)) {}
  LongDecimal(double value) : LongDecimal() { arb_set_d(value_, value); }
  LongDecimal(const LongDecimal& other) : LongDecimal() { arb_set(value_, other.value_); }
  LongDecimal& operator=(const LongDecimal& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~LongDecimal() { arb_clear(value_); }

  friend LongDecimal operator+(LongDecimal a, const LongDecimal& b) {
    arb_add(a.value_, a.value_, b.value_, bits);
    return a;
  }
  friend LongDecimal operator-(LongDecimal a, const LongDecimal& b) {
    arb_sub(a.value_, a.value_, b.value_, bits);
    return a;
  }
  friend LongDecimal operator*(LongDecimal a, const LongDecimal& b) {
    arb_mul(a.value_, a.value_, b.value_, bits);
    return a;
  }

  friend LongDecimal root_of(LongDecimal a) {
    arb_sqrt(a.value_, a.value_, bits);
    return a;
  }

  /// With so many significant digits.
  std::string text(int places) const;

 private:
  static constexpr slong bits = 400;

  LongDecimal() { arb_init(value_); }

  arb_t value_;
};

/// The square root. Precondition: a ≥ 0.
LongDecimal root_of(LongDecimal a);

}  // namespace gcs
