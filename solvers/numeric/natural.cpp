#include "solvers/numeric/natural.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace gcs {

Natural Natural::power_of_two(int exponent) {
  Natural result(1);
  fmpz_mul_2exp(result.value_, result.value_, static_cast<ulong>(exponent));
  return result;
}

std::optional<Natural> Natural::from_decimal(std::string_view digits) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  Natural result;
  fmpz_set_str(result.value_, std::string(digits).c_str(), 10);
  return result;
}

std::string Natural::decimal() const {
  const std::unique_ptr<char, void (*)(void*)> digits(fmpz_get_str(nullptr, 10, value_), flint_free);
  return digits.get();
}

double Natural::approximate() const {
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, value_);
  return std::ldexp(mantissa, static_cast<int>(std::min<slong>(exponent, 10'000)));
}

std::string readable(const Natural& count) {
  constexpr std::size_t most_digits = 18, shown_digits = 4;
  const std::string digits = count.decimal();
  if (digits.size() <= most_digits) return digits;
  return "about " + digits.substr(0, 1) + "." + digits.substr(1, shown_digits - 1) + "e" +
         std::to_string(digits.size() - 1);
}

}  // namespace gcs
