#pragma once
/// Scenes of the families on their way to a file, with lengths of many digits.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "harness/instances/long_decimal.hpp"

namespace gcs {

using ExactPoint = std::array<LongDecimal, 3>;
using DraftEdge = std::array<int, 2>;

/// Points are p1, p2, …, in edges 0, 1, …; the number after the last one is the line L.
struct Draft {
  int dimension = 3;
  int points = 0;
  std::vector<DraftEdge> edges = {};
  std::vector<LongDecimal> squares = {};  ///< of the lengths of the edges
  std::vector<std::array<double, 3>> sketch = {};
  std::vector<ExactPoint> fixed = {};  ///< empty: no positions are given
  std::string interpolation = "";      ///< as JSON; empty: the default
};

LongDecimal squared_distance(const ExactPoint& a, const ExactPoint& b);

/// With the lengths that the edges have between these points.
Draft measured_at(const std::vector<ExactPoint>& points, Draft draft);

/// The text of gcsbench-instance/1. `given`: what a constraint states, "squared" or "length"; the draft's
/// numbers are that.
std::string text_of(const std::string& id, const Draft& draft, std::string_view given = "squared");

}  // namespace gcs
