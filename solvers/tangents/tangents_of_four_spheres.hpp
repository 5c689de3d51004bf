#pragma once
/// All common tangents of four spheres, complex and multiple ones included, without an initial guess.

#include "solvers/running/work.hpp"
#include "solvers/tangents/found_tangents.hpp"

namespace gcs {

/// Joint eigenvalues (tangent_algebra.hpp), simple ones polished by Newton's method, multiple ones found as
/// the means of clusters (eigenvalue_clusters.hpp). Where the centres are nearly collinear, or not all lines
/// are found to be simple: of the spheres with their centres moved apart, if they can be, from which the
/// lines are followed back (squeezed_tangents.hpp); of the two, what tells more. Complex lines come with
/// their conjugates. Precondition: the centres are not collinear; distances are of order 1. Adds to `work`.
FoundTangents common_tangents(const FourSpheres& spheres, WorkCounters& work);

}  // namespace gcs
