#include "solvers/certificates/enclosed_point.hpp"

#include "solvers/model/ball_krawczyk.hpp"

namespace gcs {
namespace {

/// More than the doubles of an enclosure have.
constexpr slong point_bits = 128;

/// All x of the ball's real part.
Interval interval_of(acb_srcptr ball) {
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, acb_realref(ball), point_bits);
  const double low = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, acb_realref(ball), point_bits);
  const double high = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return {low, high};
}

void widen(arb_t part, double radius) {
  mag_t error;
  mag_init(error);
  mag_set_d(error, radius);
  arb_add_error_mag(part, error);
  mag_clear(error);
}

}  // namespace

BallMatrix balls_of(const Enclosure& enclosure) {
  BallMatrix balls = BallKrawczyk::vector(enclosure.mid);
  for (slong i = 0; i < balls.rows(); ++i) {
    const std::complex<double>& radius = enclosure.radius[static_cast<std::size_t>(i)];
    widen(acb_realref(balls(i, 0)), radius.real());
    widen(acb_imagref(balls(i, 0)), radius.imag());
  }
  return balls;
}

void enclose(acb_ptr sum, const LinearForm& form, const BallMatrix& unknowns, slong bits) {
  Ball coefficient;
  enclose(sum, form.constant, bits);
  for (const ScaledUnknown& term : form.terms) {
    enclose(coefficient, term.coefficient, bits);
    acb_addmul(sum, coefficient, unknowns(term.unknown, 0), bits);
  }
}

EnclosedPoint enclosed_point(const VectorForm& point, const Enclosure& enclosure) {
  const BallMatrix unknowns = balls_of(enclosure);
  const auto value_of = [&](const LinearForm& form) {
    Ball sum;
    enclose(sum, form, unknowns, point_bits);
    return interval_of(sum);
  };
  return {value_of(point[0]), value_of(point[1]), value_of(point[2])};
}

}  // namespace gcs
