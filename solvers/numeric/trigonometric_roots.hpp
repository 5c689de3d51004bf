#pragma once
/// Real zeros of a trigonometric polynomial with two harmonics: a circle meets a quadric in such.

#include <vector>

namespace gcs {

/// constant + cos1·cos φ + sin1·sin φ + cos2·cos 2φ + sin2·sin 2φ.
struct TwoHarmonics {
  double constant = 0;
  double cos1 = 0;
  double sin1 = 0;
  double cos2 = 0;
  double sin2 = 0;
};

/// All real zeros φ in (−π, π], ascending: at most 4. With t = tan(φ/2) they are the roots of a quartic in
/// t ∈ R ∪ {∞}. Zeros closer than 1e-11 count as one; a double zero may be found as two, or missed where
/// rounding lifts it off the axis, which happens within about 1e-8 of it. None where all coefficients are 0.
std::vector<double> real_zeros(const TwoHarmonics& f);

}  // namespace gcs
