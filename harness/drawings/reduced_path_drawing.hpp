#pragma once
/// Draws reduced paths as Imbach, Mathis, Schreck 2016 do in Figures 5 and 6, and figures along them.

#include <vector>

#include "harness/drawings/drawing.hpp"
#include "harness/drawings/reduced_path.hpp"

namespace gcs {

/// Of a scene that has one: t over k with one style for each branch, and the touching circles where branches
/// meet (Figure 5); and, where a trail is known, which parts are followed with the first plan, and the
/// figures at which the plan is changed (Figure 6). Empty for other scenes.
std::vector<Drawing> draw_reduced_path(const StoredScene& scene);

}  // namespace gcs
