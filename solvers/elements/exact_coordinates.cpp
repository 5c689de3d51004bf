#include "solvers/elements/exact_coordinates.hpp"

#include <flint/fmpz.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace gcs {
namespace {

using Rationals = std::vector<Rational>;

Rationals parts_of(const RationalVector& v) { return {v.begin(), v.end()}; }

/// All products of two: ‖a‖·‖b‖ is their norm.
Rationals products(const Rationals& a, const Rationals& b) {
  Rationals result;
  for (const Rational& x : a)
    for (const Rational& y : b) result.push_back(x * y);
  return result;
}

/// Integers as decimals with one common factor of ten.
class Integers {
 public:
  Integers() { fmpz_init(factor_); }
  Integers(const Integers&) = delete;
  Integers& operator=(const Integers&) = delete;
  ~Integers() { fmpz_clear(factor_); }

  /// A factor of all that makes these integers, of which the longest has one digit before the point.
  void take(const Rationals& numbers) {
    fmpz_one(factor_);
    for (const Rational& number : numbers) fmpz_lcm(factor_, factor_, fmpq_denref(number.raw()));
    digits_ = 0;
    for (const Rational& number : numbers) digits_ = std::max(digits_, text(number).size());
  }

  ExactNumber scaled(const Rational& number) const {
    ExactNumber result;
    if (number.is_zero()) return result;
    result.is_negative = number.sign() < 0;
    result.decimal = text(number) + "e-" + std::to_string(digits_ - 1);
    result.value = std::strtod(result.decimal.c_str(), nullptr);
    return result;
  }

 private:
  /// |number·factor|
  std::string text(const Rational& number) const {
    fmpz_t integer;
    fmpz_init(integer);
    fmpz_divexact(integer, factor_, fmpq_denref(number.raw()));
    fmpz_mul(integer, integer, fmpq_numref(number.raw()));
    fmpz_abs(integer, integer);
    char* digits = fmpz_get_str(nullptr, 10, integer);
    const std::string result = digits;
    flint_free(digits);
    fmpz_clear(integer);
    return result;
  }

  fmpz_t factor_;
  std::size_t digits_ = 0;
};

}  // namespace

RationalVector rational_vector(const BodyElement& element, std::size_t first, int dimension, int exponent) {
  RationalVector result;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    const Decimal& number = element.numbers[first + axis];
    if (number.value == 0) continue;
    const Rational exact =
        number.text.empty() ? Rational::from_double(number.value) : Rational::from_decimal(number.text);
    result[axis] = exact.times_power_of_two(exponent);
  }
  return result;
}

ExactNumber over_norm(const Rational& numerator, const std::vector<Rational>& parts) {
  Rationals all = parts;
  all.push_back(numerator);
  Integers integers;
  integers.take(all);
  ExactNumber result = integers.scaled(numerator);
  if (result.is_zero()) return result;
  for (const Rational& part : parts) result.divided_by_norm_of.push_back(integers.scaled(part));
  return result;
}

std::vector<ExactNumber> exact_numbers(const RationalVector& v) {
  std::vector<ExactNumber> result;
  for (const Rational& component : v) result.push_back(over_norm(component, {Rational(1)}));
  return result;
}

std::vector<ExactNumber> unit_numbers(const RationalVector& v) {
  std::vector<ExactNumber> result;
  for (const Rational& component : v) result.push_back(over_norm(component, parts_of(v)));
  return result;
}

ExactNumber exact_norm(const RationalVector& v) { return over_norm(dot(v, v), parts_of(v)); }

ExactNumber offset_from(const RationalVector& point, const BodyElement& plane, int exponent) {
  const RationalVector normal = rational_vector(plane, 0, 3, 0);
  const Rational offset = rational_vector(plane, 3, 1, exponent)[0];
  return over_norm(offset - dot(normal, point), parts_of(normal));
}

ExactBasis::ExactBasis(RationalVector d, RationalVector e)
    : d_(std::move(d)), e_(std::move(e)), dd_(dot(d_, d_)), de_(dot(d_, e_)), ee_(dot(e_, e_)) {}

ExactNumber ExactBasis::cosine() const { return over_norm(de_, products(parts_of(d_), parts_of(e_))); }

// With v = α d + β e + γ d × e and G = (d·d)(e·e) − (d·e)²:
//   G α = (v·d)(e·e) − (v·e)(d·e), G β = (v·e)(d·d) − (v·d)(d·e), G γ = v·(d × e),
// and a = α ‖d‖ = α d·d/‖d‖, b = β e·e/‖e‖, c = γ (d·d)(e·e)/(‖d‖ ‖e‖).
std::vector<ExactNumber> ExactBasis::coordinates(const RationalVector& v, bool is_unit) const {
  const Rational vd = dot(v, d_), ve = dot(v, e_);
  const Rationals gram = {dd_ * ee_ - de_ * de_};
  const Rationals divisor = is_unit ? products(gram, parts_of(v)) : gram;
  const Rationals by_d = products(divisor, parts_of(d_));
  return {over_norm((vd * ee_ - ve * de_) * dd_, by_d),
          over_norm((ve * dd_ - vd * de_) * ee_, products(divisor, parts_of(e_))),
          over_norm(dot(v, cross(d_, e_)) * dd_ * ee_, products(by_d, parts_of(e_)))};
}

}  // namespace gcs
