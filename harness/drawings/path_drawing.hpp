#pragma once
/// The path S of an instance as static plots, for one column of a paper.

#include <array>
#include <optional>
#include <vector>

#include "harness/drawings/drawing.hpp"
#include "harness/runs/shown_scene_files.hpp"

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
std::string name_of(const PathCoordinate& coordinate, const ProblemStatement& problem);

/// The first trail that has places, or nullptr.
const PlanTrail* shown_trail(const ShownScene& record);

/// A place on the polyline: so much of the way from one corner to the next.
struct PathPosition {
  std::size_t corner = 0;
  double part = 0;

  /// Of what has one value at each corner.
  double between(const std::vector<double>& values) const {
    const double here = values[corner];
    return part > 0 ? here + part * (values[corner + 1] - here) : here;
  }
};

/// Where the arc length is `length`, between 0 and the whole.
PathPosition position_at(const StoredPath& path, double length);

/// The figure there.
Figure figure_at(const StoredPath& path, const PathPosition& position);

/// t over the widest coordinate, with the sketch, the solutions and, up to 100, the changes of plan.
/// Precondition: the scene has a path.
Drawing draw_path(const StoredScene& scene);

}  // namespace gcs
