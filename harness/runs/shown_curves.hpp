#pragma once
/// What moves on a page beside S: motions of a scene, and the graph that `explore` walks.

#include <optional>
#include <vector>

#include "harness/runs/run_file.hpp"
#include "harness/runs/shown_scene.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// A point of S that a tracker accepted is good to this part of the scene's size, and other arcs are further.
inline constexpr double same_place = 1e-5;

/// Of which solution the figure, in the frame and the file's unit, is an image; nothing where it is none of them.
std::optional<MetSolution> nearest_solution(const Scene& scene, const Figure& figure,
                                            const std::vector<ShownSolution>& solutions);

/// A graph of more edges is shown as a forest: those by which each solution is come to first.
inline constexpr std::size_t most_shown_edges = 400;

/// Of the first cell of the run in which the scene moves its motions, and of the first one of `explore` its edges: stretches
/// of its curves from one solution of the record to the next. Both are solved again, for `limit_s` seconds each at most.
std::vector<ShownCurve> curves_to_show(const Scene& scene, const RunFile& run, const ShownScene& record,
                                       double limit_s, Monitor& progress);

}  // namespace gcs
