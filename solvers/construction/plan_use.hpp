#pragma once
/// Where on S a construction plan takes over.

#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// From (figure, t) on S is followed with a plan that builds on all constraints but `removed`.
struct PlanUse {
  Figure figure;  ///< in the scene's unit, in any position
  double t = 0;
  std::vector<int> removed{};  ///< numbers of constraints, growing
};

}  // namespace gcs
