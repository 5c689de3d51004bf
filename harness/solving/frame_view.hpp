#pragma once
/// Which element of a scene is put where, by name.

#include <string>
#include <utility>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/reading/json_document.hpp"

namespace gcs {

/// The parts of the frame with the elements that are put there, by the names of the instance format: a body, or what
/// the reference uses of origin, axis, plane, line and height. None where positions are fixed.
std::vector<std::pair<std::string, std::string>> frame_parts(const Scene& scene);

/// The names of the elements with given positions.
std::vector<std::string> fixed_names(const ProblemStatement& problem);

/// The parts as an object; where positions are fixed, the member `fixed` lists what has one.
JsonValue frame_value(const Scene& scene);

}  // namespace gcs
