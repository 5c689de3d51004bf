#include "solvers/model/exact_square.hpp"

namespace gcs {

Rational exact_square(const DistanceConstraint& constraint) {
  const Decimal& given = constraint.given;
  const Rational number =
      given.text.empty() ? Rational::from_double(given.value) : Rational::from_decimal(given.text);
  return constraint.is_squared ? number : number * number;
}

}  // namespace gcs
