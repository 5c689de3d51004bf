#pragma once
/// S as its first construction plan sees it, in the plane and where the plan has one driving parameter k: the
/// sequence of reduced paths in (k, t) of Imbach, Mathis, Schreck 2016, Figures 5 and 6.

#include <optional>
#include <string>
#include <vector>

#include "harness/runs/shown_scene_files.hpp"
#include "solvers/construction/plan.hpp"

namespace gcs {

/// A figure near S at which the circles of one instruction touch, so that the branch changes.
struct BoundaryPlace {
  Figure figure;  ///< in the plan's frame and the file's unit
  double t = 0;
  double k = 0;
  std::size_t instruction = 0;
};

struct ReducedPath {
  Plan plan;              ///< lengths in the scene's unit
  int driven_place = -1;  ///< the point whose distance from the fixed copy of `driven_from` is k
  int driven_from = -1;
  std::vector<double> k;                  ///< at every corner of the path, in the file's unit
  std::vector<std::string> branches;      ///< likewise: "+−+", one sign for each intersection
  std::vector<BoundaryPlace> boundaries;  ///< in the order of S
};

/// Nothing for a scene in space, without a path, or whose first plan has another number of driving
/// parameters.
std::optional<ReducedPath> reduced_path(const StoredScene& scene);

}  // namespace gcs
