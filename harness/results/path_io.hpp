#pragma once
/// Writes gcsbench-path/1: the proven path S as a polyline, for plots.

#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/proven_paths/proven_path.hpp"

namespace gcs {

/// Why there is no such text of the scene's S, or nothing.
std::optional<std::string> why_no_path_text(const Scene& scene);

/// The closed path that `arcs`, not empty, make up, in the file's unit and the scene's frame, with few
/// decimals. A row for each corner: t, arc length from the sketch, radius, and every coordinate that moves;
/// the frame's coordinates that do not are in `fixed`. The part of S from a row to the next is within the
/// row's radius of the segment between them, rounding of the decimals included, in the 2-norm of
/// (X, unit · t): `unit` is the scene's unit, a power of two in the file's. `within`: the radius wanted,
/// relative to the scene's size; see polyline for when it is exceeded.
std::string path_text(const Instance& instance, const Scene& scene, const std::vector<ProvenArc>& arcs,
                      double within);

}  // namespace gcs
