#pragma once
/// Whether a solution at which paths end can be isolated up to rigid motions.
///
/// At lengths nearby so many solutions are next to an isolated one as its multiplicity says, and as many paths end there, in
/// classes up to reflection: half as many where it is its own mirror image.

#include "solvers/model/scene.hpp"

namespace gcs {

/// For the figure of a scene of points, with a line at most, to 1e-8 of its size; false where doubles do not tell. The frame
/// is no part of the question: where its points are in a line others take their place.
bool can_be_isolated(const Scene& scene, const Figure& figure, int paths);

}  // namespace gcs
