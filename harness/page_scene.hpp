#pragma once
/// The part of the page about one instance.

#include <string>

#include "harness/scene_store.hpp"

namespace gcs {

/// `number`: of the scene among those of page_data.
std::string scene_html(const StoredScene& scene, std::size_t number);

/// Of an instance of which nothing was stored.
std::string missing_scene_html(const std::string& id);

}  // namespace gcs
