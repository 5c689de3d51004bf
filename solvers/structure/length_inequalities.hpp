#pragma once
/// Polygon inequalities: given lengths that no placement whatsoever can have.

#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A given distance that is longer than another way between the same two entities.
struct ViolatedInequality {
  int constraint = -1;  ///< that gives the distance; −1: the positions of two fixed entities do
  double length = 0;
  double other_way = 0;          ///< length of the shorter way
  std::vector<int> entities;     ///< along the other way, both ends included
  std::vector<int> constraints;  ///< `constraint` first unless it is −1, then those of the other way
};

/// For |p − q|: no other way from p to q over given point–point distances may be shorter. For d(p, L):
/// d(p, L) ≤ |way from p to q| + d(q, L) for every other point q whose distance to L is given. Distances
/// between fixed entities count as given. A way is shorter only when it is so beyond the rounding of the
/// lengths and of their sum, so that flat triangles such as 0.1 + 0.7 = 0.8 pass. One entry per given
/// distance at most.
std::vector<ViolatedInequality> violated_inequalities(const ProblemStatement& problem);

}  // namespace gcs
