#include "solvers/certificates/enclosed_point.hpp"

#include "solvers/numeric/balls.hpp"

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

Interval value_of(const LinearForm& form, const Enclosure& enclosure) {
  Ball sum, coefficient, unknown, width;
  enclose(sum, form.constant, point_bits);
  for (const ScaledUnknown& term : form.terms) {
    const auto i = static_cast<std::size_t>(term.unknown);
    enclose(coefficient, term.coefficient, point_bits);
    acb_set_d(unknown, enclosure.mid[i].real());
    acb_set_d(width, enclosure.radius[i].real());
    acb_ptr value = unknown, radius = width;
    arb_add_error(acb_realref(value), acb_realref(radius));
    acb_addmul(sum, coefficient, unknown, point_bits);
  }
  return interval_of(sum);
}

}  // namespace

EnclosedPoint enclosed_point(const VectorForm& point, const Enclosure& enclosure) {
  return {value_of(point[0], enclosure), value_of(point[1], enclosure), value_of(point[2], enclosure)};
}

}  // namespace gcs
