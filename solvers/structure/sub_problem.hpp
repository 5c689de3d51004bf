#pragma once
/// A part of a problem as a problem of its own.

#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct SubProblem {
  ProblemStatement problem;
  std::vector<int> entities;  ///< of each entity, its number in the whole problem
};

/// The entities that `is_there`, in their order, with what is stated between them alone, the bodies whose elements are
/// all there, given positions that leave no motion, their places in the sketch and the bends; with the frame where all of it is there; without a construction
/// plan.
SubProblem sub_problem(const ProblemStatement& whole, const std::vector<bool>& is_there);

}  // namespace gcs
