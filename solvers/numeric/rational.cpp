#include "solvers/numeric/rational.hpp"

#include <arb.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace gcs {
namespace {

/// So many that rounding to a double is the only error of note.
constexpr slong bits = 128;

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("'" + text + "' is no decimal number");
}

int exponent_of(const std::string& text, std::size_t mark) {
  if (mark == std::string::npos) return 0;
  const std::size_t first = mark + (text.compare(mark + 1, 1, "+") == 0 ? 2 : 1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data() + first, text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size()) refuse(text);
  return exponent;
}

/// `compute` fills a ball of `bits` bits.
template <class Compute>
double from_ball(const Compute& compute) {
  arb_t ball;
  arb_init(ball);
  compute(ball);
  const double value = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
  arb_clear(ball);
  return value;
}

}  // namespace

Rational Rational::from_decimal(const std::string& text) {
  const std::size_t mark = text.find_first_of("eE");
  std::string digits = text.substr(0, mark);
  if (digits.find('0') != std::string::npos && digits.find_first_not_of("-+.0") == std::string::npos)
    return Rational(0);
  int exponent = exponent_of(text, mark);
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  fmpz_t whole, power;
  fmpz_init(whole);
  fmpz_init(power);
  const bool is_number = fmpz_set_str(whole, digits.c_str(), 10) == 0;
  fmpz_set_ui(power, 10);
  fmpz_pow_ui(power, power, static_cast<ulong>(std::abs(exponent)));
  Rational result;
  if (exponent >= 0) fmpz_mul(whole, whole, power);
  fmpq_set_fmpz(result.value_, whole);
  if (exponent < 0) fmpq_div_fmpz(result.value_, result.value_, power);
  fmpz_clear(whole);
  fmpz_clear(power);
  if (!is_number) refuse(text);
  return result;
}

Rational Rational::from_double(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  constexpr int mantissa_bits = 53;
  return Rational(static_cast<long>(std::ldexp(mantissa, mantissa_bits)))
      .times_power_of_two(exponent - mantissa_bits);
}

Rational Rational::times_power_of_two(int exponent) const {
  Rational result;
  if (exponent >= 0)
    fmpq_mul_2exp(result.value_, value_, static_cast<ulong>(exponent));
  else
    fmpq_div_2exp(result.value_, value_, static_cast<ulong>(-exponent));
  return result;
}

std::optional<Rational> Rational::root() const {
  if (!fmpz_is_square(fmpq_numref(value_)) || !fmpz_is_square(fmpq_denref(value_))) return std::nullopt;
  Rational result;
  fmpz_sqrt(fmpq_numref(result.value_), fmpq_numref(value_));
  fmpz_sqrt(fmpq_denref(result.value_), fmpq_denref(value_));
  return result;
}

double Rational::approximate() const {
  return from_ball([this](arb_t ball) { arb_set_fmpq(ball, value_, bits); });
}

double Rational::approximate_root() const {
  return from_ball([this](arb_t ball) {
    arb_set_fmpq(ball, value_, bits);
    arb_sqrt(ball, ball, bits);
  });
}

}  // namespace gcs
