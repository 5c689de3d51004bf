#include "solvers/numeric/natural.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {

Natural Natural::power_of_two(int exponent) {
  Natural result;
  result.limbs_.assign(static_cast<std::size_t>(exponent / limb_bits) + 1, 0);
  result.limbs_.back() = Limb{1} << (exponent % limb_bits);
  return result;
}

std::optional<Natural> Natural::from_decimal(std::string_view digits) {
  if (digits.empty()) return std::nullopt;
  Natural result;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') return std::nullopt;
    result = result * Natural(10);
    result += Natural(static_cast<std::uint64_t>(digit - '0'));
  }
  return result;
}

std::string Natural::decimal() const {
  std::string digits;
  for (Natural rest = *this; !rest.is_zero();) digits.push_back(static_cast<char>('0' + rest.divide(10)));
  if (digits.empty()) return "0";
  std::reverse(digits.begin(), digits.end());
  return digits;
}

double Natural::approximate() const {
  double value = 0;
  for (auto limb = limbs_.rbegin(); limb != limbs_.rend(); ++limb)
    value = std::ldexp(value, limb_bits) + static_cast<double>(*limb);
  return value;
}

Natural& Natural::operator+=(const Natural& other) {
  limbs_.resize(std::max(limbs_.size(), other.limbs_.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    carry += std::uint64_t{limbs_[i]} + (i < other.limbs_.size() ? other.limbs_[i] : 0);
    limbs_[i] = static_cast<Limb>(carry);
    carry >>= limb_bits;
  }
  trim();
  return *this;
}

Natural operator*(const Natural& a, const Natural& b) {
  Natural product;
  product.limbs_.resize(a.limbs_.size() + b.limbs_.size());
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    std::uint64_t carry = 0;  // at most (2^32 − 1)² + 2(2^32 − 1) = 2^64 − 1 before it is shifted
    for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
      carry += std::uint64_t{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = static_cast<Natural::Limb>(carry);
      carry >>= Natural::limb_bits;
    }
    product.limbs_[i + b.limbs_.size()] = static_cast<Natural::Limb>(carry);
  }
  product.trim();
  return product;
}

std::strong_ordering operator<=>(const Natural& a, const Natural& b) {
  if (a.limbs_.size() != b.limbs_.size()) return a.limbs_.size() <=> b.limbs_.size();
  return std::lexicographical_compare_three_way(a.limbs_.rbegin(), a.limbs_.rend(), b.limbs_.rbegin(),
                                                b.limbs_.rend());
}

std::string readable(const Natural& count) {
  constexpr std::size_t most_digits = 18, shown_digits = 4;
  const std::string digits = count.decimal();
  if (digits.size() <= most_digits) return digits;
  return "about " + digits.substr(0, 1) + "." + digits.substr(1, shown_digits - 1) + "e" +
         std::to_string(digits.size() - 1);
}

void Natural::trim() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
}

Natural::Limb Natural::divide(Limb divisor) {
  std::uint64_t rest = 0;
  for (auto limb = limbs_.rbegin(); limb != limbs_.rend(); ++limb) {
    rest = rest << limb_bits | *limb;
    *limb = static_cast<Limb>(rest / divisor);
    rest %= divisor;
  }
  trim();
  return static_cast<Limb>(rest);
}

}  // namespace gcs
