#pragma once
/// Vectors of space with rational components.

#include <array>

#include "solvers/numeric/rational.hpp"

namespace gcs {

using RationalVector = std::array<Rational, 3>;

RationalVector operator-(const RationalVector& a, const RationalVector& b);
Rational dot(const RationalVector& a, const RationalVector& b);
RationalVector cross(const RationalVector& a, const RationalVector& b);
bool is_zero(const RationalVector& a);

}  // namespace gcs
