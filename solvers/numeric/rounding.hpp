#pragma once
/// The rounding of doubles, to which bounds and tolerances are relative.

#include <limits>

namespace gcs {

/// From 1 to the next double.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// A result is rounded by so much of itself at most.
inline constexpr double unit_roundoff = epsilon / 2;
/// Above all that products lose below the smallest normal number.
inline constexpr double underflow = 0x1p-1000;

}  // namespace gcs
