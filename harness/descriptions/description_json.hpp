#pragma once
/// A description for programs.

#include <string>

#include "harness/descriptions/description.hpp"

namespace gcs {

/// One JSON object. What is said of distances alone is null for other scenes.
std::string json_description(const Description& description);

}  // namespace gcs
