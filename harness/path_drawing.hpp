#pragma once
/// The path S of an instance as static plots, for one column of a paper.

#include <array>
#include <optional>
#include <vector>

#include "harness/scene_store.hpp"
#include "harness/tables.hpp"

namespace gcs {

/// One coordinate of a point.
struct PathCoordinate {
  int point = 0;
  int axis = 0;
};

/// Those that are not the same all along the path, in the order of points and axes.
std::vector<PathCoordinate> moving_coordinates(const StoredPath& path, int dimension);

/// The index of the one that covers the widest range. Precondition: there is one.
std::size_t widest_coordinate(const StoredPath& path, const std::vector<PathCoordinate>& coordinates);

/// "y of p4"
std::string name_of(const PathCoordinate& coordinate, const Problem& problem);

/// The first trail that has places, or nullptr.
const PlanTrail* shown_trail(const SceneRecord& record);

/// The corner at which the arc length is `length`, or the last one before it.
std::size_t corner_at(const StoredPath& path, double length);

/// t over the widest coordinate, with the sketch, the solutions and, up to 100, the changes of plan.
/// Precondition: the scene has a path.
Drawing draw_path(const StoredScene& scene);

}  // namespace gcs
