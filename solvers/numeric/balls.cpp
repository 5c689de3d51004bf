#include "solvers/numeric/balls.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace gcs {

void enclose(acb_ptr ball, const ExactNumber& number, slong bits) {
  acb_set_d_d(ball, number.value.real(), number.value.imag());
  if (!number.decimal.empty() && arb_set_str(acb_realref(ball), number.decimal.c_str(), bits) != 0)
    throw std::invalid_argument("'" + number.decimal + "' is no decimal number");
  if (number.is_cosine_of_degrees) {
    acb_div_ui(ball, ball, 180, bits);
    acb_cos_pi(ball, ball, bits);
  }
  acb_mul_2exp_si(ball, ball, number.exponent);
  if (number.is_squared) acb_sqr(ball, ball, bits);
  if (!number.divided_by_norm_of.empty()) {
    Ball norm, part;
    for (const ExactNumber& component : number.divided_by_norm_of) {
      enclose(part, component, bits);
      acb_addmul(norm, part, part, bits);
    }
    acb_sqrt(norm, norm, bits);
    acb_div(ball, ball, norm, bits);
  }
  if (number.is_negative) acb_neg(ball, ball);
}

std::complex<double> rounded_midpoint(acb_srcptr ball) {
  return {arf_get_d(arb_midref(acb_realref(ball)), ARF_RND_NEAR),
          arf_get_d(arb_midref(acb_imagref(ball)), ARF_RND_NEAR)};
}

double magnitude(acb_srcptr ball) {
  mag_t bound;
  mag_init(bound);
  acb_get_mag(bound, ball);
  const double value = mag_is_inf(bound) ? std::numeric_limits<double>::infinity() : mag_get_d(bound);
  mag_clear(bound);
  return value * (1 + std::numeric_limits<double>::epsilon());
}

double least_magnitude(acb_srcptr ball) {
  mag_t bound;
  mag_init(bound);
  acb_get_mag_lower(bound, ball);
  const double value = mag_get_d(bound);
  mag_clear(bound);
  constexpr double least = 0x1p-1000, most = 0x1p1000;  // mag_get_d rounds up beyond
  return value <= least ? 0 : std::min(value, most) * (1 - std::numeric_limits<double>::epsilon());
}

}  // namespace gcs
