#pragma once
/// The families by kind of scene.

#include <span>

#include "harness/instances/family.hpp"

namespace gcs {

/// Flat figures, folds and paths.
std::span<const InstanceFamily> flat_families();
/// Points and a line.
std::span<const InstanceFamily> line_families();
/// Octahedra, and what is built like them.
std::span<const InstanceFamily> octahedron_families();
/// Scenes of several parts.
std::span<const InstanceFamily> compound_families();

/// Lines, planes, angles and bodies.
std::span<const InstanceFamily> general_families();

/// ε from a tame value to 1e-15.
std::vector<std::string> shrinking(const std::string& tame = "0.5");
/// And at last 0.
std::vector<std::string> shrinking_to_zero(const std::string& tame = "0.5");

}  // namespace gcs
