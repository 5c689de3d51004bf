#pragma once
/// What the unknowns of a scene's equations are called.

#include <string>
#include <vector>

#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

/// A name for each unknown. Of the point P: P_x, P_y, P_z. Of the line L its point nearest to the origin L_x, L_y, L_z,
/// its direction L_ux … and, in a scene of distances, the vector product of both L_mx …; of the plane H its unit normal
/// H_nx … and its offset H_h; of the body B the place of its origin B_tx … and the images of its axes B_ex …, B_fx …,
/// B_gx …. Any other is u1, u2, …: lengths and directions of segments, and what keeps equations of degree two.
std::vector<std::string> unknown_names(const Scene& scene, const SceneEquations& equations);

}  // namespace gcs
