#pragma once
/// The parts of a scene that can be solved one after another.

#include <algorithm>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Points that are placed together, on d points that are there already. Of several points, the d are pairwise
/// at given distances, so that the part's solutions do not depend on the rest; a single one is placed by its
/// distances from the d.
struct Part {
  std::vector<int> base;  ///< d points of earlier parts; empty: this is the first part
  /// Between the points of the base, 0–1, 0–2 and 1–2 (in the plane the first); −1 where no distance is
  /// given.
  std::vector<int> base_constraints;
  std::vector<int> points;  ///< those that it places
  /// Those between points of the part, base included; of a single point its distances from the base, in the
  /// order of the base.
  std::vector<int> constraints;

  bool is_hung_point() const { return !base.empty() && points.size() == 1; }
  /// Whether all distances between points of the base are given.
  bool has_given_base() const {
    return std::find(base_constraints.begin(), base_constraints.end(), -1) == base_constraints.end();
  }
};

/// How far a scene is taken apart.
enum class Split {
  hung_points,  ///< points that can be placed after all others, and what is left
  /// What is left also where d points, pairwise at given distances, separate it (Owen, Algebraic solution for
  /// geometry from dimensional constraints, 1991: there also where they are not).
  all
};

/// In an order in which they can be solved. The first part holds d + 2 points at least, so that there is
/// something to solve, unless that is more than there are. One part where positions are given; lines stay in
/// the first part. Precondition: the problem is well posed (see analyse_structure).
std::vector<Part> decompose(const ProblemStatement& problem, Split split);

/// A part with several points or the first one as a problem of its own: base and points in the order of the
/// problem, lines in the first part. Its frame is the base; in the first part it is the problem's if that
/// lies in it. With the sketch of what is in it, and with the bent constraints that are; a construction plan
/// of the whole is of no use for it.
struct PartProblem {
  ProblemStatement problem;
  std::vector<int> points;  ///< of each point, its number in the whole problem
};
PartProblem part_problem(const ProblemStatement& whole, const Part& part);

}  // namespace gcs
