#pragma once
/// What the scripts of the page work with.

#include <string>
#include <vector>

#include "harness/runs/shown_scene_files.hpp"

namespace gcs {

/// {"scenes": […]} as JSON. Entities are numbered points first, then lines, then planes; vectors have three numbers, in
/// the file's unit. `edges`: distances. `turns` of a solution: of each body the rotation that it has there. `path.rows`: t, arc length and the moving coordinates of each corner. `coordinate`: the
/// number of the one that a plot of S begins with, 0 being the arc length and the moving coordinates
/// following.
std::string page_data(const std::vector<const StoredScene*>& scenes);

}  // namespace gcs
