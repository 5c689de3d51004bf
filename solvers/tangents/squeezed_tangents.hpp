#pragma once
/// The common tangents of four spheres from those of spheres that are further from collinear.
///
/// Each line is followed as the distances of the centres from an axis shrink from those of the widened
/// spheres (strip.hpp) to the given ones, a power of the same ratio in each stretch. Between the two ends
/// centres and radii are perturbed at random by complex numbers that shrink likewise, so that no two lines
/// meet on the way. Every stretch of every path has a rotation b of its own, in which the line's direction is
/// of order 1 (squeeze_homotopy.hpp): a simple line is as well-conditioned at the end as at the start. Those
/// at infinity stay there, being given by parallel edges.

#include <random>
#include <vector>

#include "solvers/running/work.hpp"
#include "solvers/tangents/found_tangents.hpp"
#include "solvers/tangents/strip.hpp"

namespace gcs {

struct SqueezedTangents {
  FoundTangents found;
  std::vector<bool> has_end;  ///< of each line of the widened spheres: whether its path has a regular end
};

/// `wide`: the tangents of strip.widened_spheres(). Multiple ones are not followed, and multiple ends count
/// as none. Deterministic but for `random`. Precondition: lengths are of order 1. Adds to `work`.
SqueezedTangents squeezed_tangents(const FourSpheres& spheres, const Strip& strip, const FoundTangents& wide,
                                   std::mt19937_64& random, WorkCounters& work);

}  // namespace gcs
