#pragma once
/// Writes gcsbench-follow/1: how a figure moves along a polyline of values.

#include <string>
#include <vector>

#include "solvers/reading/instance_parser.hpp"
#include "solvers/solving/follow.hpp"

namespace gcs {

/// A figure from which one was followed, and where to.
struct FollowedPolyline {
  Figure from;  ///< in the file's unit
  std::vector<ChangedValues> vertices;
  std::vector<Followed> legs;  ///< as follow_polyline says
};

/// As JSON text that ends in a newline, one leg a line; what does not apply is null.
std::string follow_text(const Instance& instance, const FollowedPolyline& polyline);

}  // namespace gcs
