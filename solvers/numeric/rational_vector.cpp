#include "solvers/numeric/rational_vector.hpp"

#include <algorithm>

namespace gcs {

RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const RationalVector& a) {
  return std::all_of(a.begin(), a.end(), [](const Rational& x) { return x.is_zero(); });
}

}  // namespace gcs
