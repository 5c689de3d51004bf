#pragma once
/// Spheres with coinciding or collinear centres, to which the tangent equations do not apply. A line keeps a
/// point's distance when it is turned about an axis through it: such spheres have no common tangent or
/// infinitely many complex ones.

#include <optional>
#include <string>

#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

struct DegenerateTangents {
  std::string why_infinite;  ///< a sentence; empty: there is no common tangent, not even a complex one
  std::optional<Tangent<double>> only_real_line;
};

/// Nothing where the centres are distinct and not collinear. All decisions are to rounding. Precondition:
/// lengths are of order 1.
std::optional<DegenerateTangents> degenerate_tangents(const FourSpheres& spheres);

}  // namespace gcs
