#pragma once
/// Rational numbers of any size, by the library FLINT: signs of expressions in decimals are decided with
/// them.

#include <flint/fmpq.h>

#include <optional>
#include <string>

namespace gcs {

class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(long value) : Rational() { fmpq_set_si(value_, value, 1); }  // NOLINT(google-explicit-constructor)
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational& operator=(const Rational& other) {
    fmpq_set(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  /// The number that a text such as "-1.25e-3" stands for. Throws std::invalid_argument for any other text.
  static Rational from_decimal(const std::string& text);
  /// Precondition: finite.
  static Rational from_double(double value);

  Rational times_power_of_two(int exponent) const;
  /// −1, 0 or 1.
  int sign() const { return fmpq_sgn(value_); }
  bool is_zero() const { return sign() == 0; }
  /// The square root ≥ 0, where that is rational.
  std::optional<Rational> root() const;
  /// The nearest double or a neighbour of it.
  double approximate() const;
  /// The same of the square root. Precondition: sign() ≥ 0.
  double approximate_root() const;

  friend Rational operator+(const Rational& a, const Rational& b) { return apply(fmpq_add, a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return apply(fmpq_sub, a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return apply(fmpq_mul, a, b); }
  /// Precondition: b.sign() != 0.
  friend Rational operator/(const Rational& a, const Rational& b) { return apply(fmpq_div, a, b); }
  /// For FLINT's functions.
  const fmpq* raw() const { return value_; }
  static Rational from_raw(const fmpq* value) {
    Rational result;
    fmpq_set(result.value_, value);
    return result;
  }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }

 private:
  static Rational apply(void (*operation)(fmpq_t, const fmpq_t, const fmpq_t), const Rational& a,
                        const Rational& b) {
    Rational result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }

  fmpq_t value_;
};

}  // namespace gcs
