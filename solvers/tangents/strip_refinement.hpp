#pragma once
/// Newton's method on a common tangent in isotropic coordinates and double-double.

#include <optional>

#include "solvers/running/work.hpp"
#include "solvers/tangents/found_tangents.hpp"
#include "solvers/tangents/scaled_line.hpp"

namespace gcs {

/// The common tangent near `line`, with the point nearest to the spheres' origin and u·u = 1: every
/// coordinate is the nearest double to the exact one's, but for those that are far below the others. Nothing
/// where Newton's method does not converge as it does at a simple line. Precondition: lengths are of order 1.
/// Adds to `work`.
std::optional<ComplexTangent> refined_in_strip(const FourSpheres& spheres, const Strip& strip,
                                               const ScaledLine& line, WorkCounters& work);

}  // namespace gcs
