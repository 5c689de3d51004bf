#pragma once
/// The part of the page about one instance.

#include <string>
#include <vector>

#include "harness/drawings/drawing.hpp"
#include "harness/runs/shown_scene_files.hpp"

namespace gcs {

/// The figures of a scene, as they are written to files: its constraint graph and, where S is stored, S.
std::vector<Drawing> draw_scene(const StoredScene& scene);

/// `number`: of the scene among those of page_data.
std::string scene_html(const StoredScene& scene, std::size_t number);

/// Of an instance of which nothing was stored.
std::string missing_scene_html(const std::string& id);

}  // namespace gcs
