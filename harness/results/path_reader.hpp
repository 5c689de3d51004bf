#pragma once
/// Reads gcsbench-path/1: the path S as a polyline.

#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct Instance;

/// A corner of the polyline, in the file's unit.
struct PathCorner {
  Figure figure;  ///< in the scene's frame
  double t = 0;
  double length = 0;  ///< arc length of S from the sketch
};

/// A corner at which S crosses t = 1.
struct PathCrossingCorner {
  std::size_t corner = 0;
  int direction = 1;  ///< sign of dt
};

struct StoredPath {
  double within = 0;                ///< how far S may be from the polyline, relative to the scene's size
  double length = 0;                ///< of S
  std::vector<PathCorner> corners;  ///< the last one is the first again
  std::vector<PathCrossingCorner> crossings;
};

/// The path in `text`, which is of `instance`; `file` is for messages. Throws InputError.
StoredPath parse_path(const std::string& text, const std::string& file, const Instance& instance);

}  // namespace gcs
