#pragma once
/// Where all solutions of a scene are: a box for the unknowns of its equations.

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

/// For each kind of mirror image that leaves a solution's class, the unknown of which one sign is enough: in
/// every class there is a solution where all of them are not negative. A coordinate to which the frame gives a
/// sign, else the first that has no given place.
std::vector<int> signed_unknowns(const Scene& scene, const SceneEquations& equations);

/// A box that holds a solution of every class. A point is no farther from another one than the shortest way
/// between them over given distances, so that each coordinate that the frame or the file gives bounds those of
/// the other points; of signed unknowns it has what is not negative. A free line's direction has length 1, and
/// its distance from the origin is at most that of a given point and of the line from there. Some sides are
/// infinite where no such way leads to what is given. Precondition: !why_not_certified(scene).
IntervalBox start_box(const Scene& scene, const SceneEquations& equations);

}  // namespace gcs
