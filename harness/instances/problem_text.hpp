#pragma once
/// Writes gcsbench-instance/1.

#include <string>

#include "solvers/model/scene.hpp"

namespace gcs {

/// What a strategy may know of the scene, as an instance in the file's unit, with the decimal texts of all
/// lengths: no name, title or published figures. The reference is the scene's, also where the file gave none.
std::string problem_text(const Scene& scene, const std::string& id = "instance");

}  // namespace gcs
