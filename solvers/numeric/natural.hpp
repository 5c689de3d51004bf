#pragma once
/// Natural numbers of any size. Numbers of solutions double with every point that hangs on others: no
/// built-in type holds those of a long chain.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gcs {

class Natural {
 public:
  Natural() = default;  ///< 0
  Natural(std::uint64_t value) : limbs_{static_cast<Limb>(value), static_cast<Limb>(value >> limb_bits)} {
    trim();
  }
  static Natural power_of_two(int exponent);
  /// The number that a text of digits 0 to 9 stands for; nothing for any other text.
  static std::optional<Natural> from_decimal(std::string_view digits);

  bool is_zero() const { return limbs_.empty(); }
  std::string decimal() const;
  /// The nearest double but for rounding of the last bits; infinite beyond the largest double.
  double approximate() const;

  Natural& operator+=(const Natural& other);
  friend Natural operator*(const Natural& a, const Natural& b);
  /// The quotient, rounded down. Precondition: divisor > 0.
  friend Natural operator/(Natural dividend, std::uint32_t divisor) {
    dividend.divide(divisor);
    return dividend;
  }
  friend bool operator==(const Natural&, const Natural&) = default;
  friend std::strong_ordering operator<=>(const Natural& a, const Natural& b);

 private:
  using Limb = std::uint32_t;
  static constexpr int limb_bits = 32;

  void trim();
  /// Divides in place and returns the remainder.
  Limb divide(Limb divisor);

  std::vector<Limb> limbs_;  ///< base 2^32, the lowest first; the highest is not 0
};

/// In full up to 18 digits, beyond that about as large: "about 8.572e303".
std::string readable(const Natural& count);

}  // namespace gcs
