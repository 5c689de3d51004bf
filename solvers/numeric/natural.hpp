#pragma once
/// Natural numbers of any size, by the library FLINT. Numbers of solutions double with every point that hangs on
/// others: no built-in type holds those of a long chain.

#include <flint/fmpz.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gcs {

class Natural {
 public:
  Natural() { fmpz_init(value_); }  ///< 0
  Natural(std::uint64_t value) : Natural() { fmpz_set_ui(value_, value); }
  Natural(const Natural& other) : Natural() { fmpz_set(value_, other.value_); }
  Natural(Natural&& other) noexcept : Natural() { fmpz_swap(value_, other.value_); }
  Natural& operator=(Natural other) noexcept {
    fmpz_swap(value_, other.value_);
    return *this;
  }
  ~Natural() { fmpz_clear(value_); }

  static Natural power_of_two(int exponent);
  /// The number that a text of digits 0 to 9 stands for; nothing for any other text.
  static std::optional<Natural> from_decimal(std::string_view digits);

  bool is_zero() const { return fmpz_is_zero(value_) != 0; }
  std::string decimal() const;
  /// The nearest double but for rounding of the last bits; infinite beyond the largest double.
  double approximate() const;

  Natural& operator+=(const Natural& other) {
    fmpz_add(value_, value_, other.value_);
    return *this;
  }
  /// Precondition: a ≥ b.
  friend Natural operator-(const Natural& a, const Natural& b) {
    Natural difference;
    fmpz_sub(difference.value_, a.value_, b.value_);
    return difference;
  }
  friend Natural operator*(const Natural& a, const Natural& b) {
    Natural product;
    fmpz_mul(product.value_, a.value_, b.value_);
    return product;
  }
  /// The quotient, rounded down. Precondition: divisor > 0.
  friend Natural operator/(const Natural& dividend, std::uint32_t divisor) {
    Natural quotient;
    fmpz_fdiv_q_ui(quotient.value_, dividend.value_, divisor);
    return quotient;
  }
  friend bool operator==(const Natural& a, const Natural& b) { return fmpz_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Natural& a, const Natural& b) {
    return fmpz_cmp(a.value_, b.value_) <=> 0;
  }

 private:
  fmpz_t value_;
};

/// In full up to 18 digits, beyond that about as large: "about 8.572e303".
std::string readable(const Natural& count);

}  // namespace gcs
