#pragma once
/// Spheres with coinciding or collinear centres, to which the tangent equations do not apply. A line keeps a
/// point's distance when it is turned about an axis through it: such spheres have no common tangent or
/// infinitely many complex ones.

#include <optional>
#include <string>

#include "solvers/tangents/exact_spheres.hpp"
#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

struct DegenerateTangents {
  std::string why_infinite;  ///< a sentence; empty: there is no common tangent, not even a complex one
  bool has_axis = false;     ///< the line of the centres is a common tangent, the only real one
};

/// Nothing where the centres are distinct and not collinear. All decisions are exact.
std::optional<DegenerateTangents> degenerate_tangents(const ExactSpheres& spheres);

/// Why doubles do not tell these spheres from concentric ones, in a sentence; nothing where they do.
/// Precondition: lengths are of order 1.
std::optional<std::string> why_nearly_concentric(const FourSpheres& spheres);

/// The line through the centres, which are collinear.
Tangent<double> line_of_centers(const FourSpheres& spheres);

}  // namespace gcs
