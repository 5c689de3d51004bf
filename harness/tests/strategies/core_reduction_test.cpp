#include "solvers/structure/core_reduction.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "harness/tests/instances/toy_scene.hpp"

using namespace gcs;

namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// A problem with the given numbers of entities; lines are numbered after the points.
ProblemStatement problem_of(int dimension, int points, int lines, const Pairs& constrained) {
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  for (int i = 0; i < lines; ++i) problem.lines.push_back("L" + std::to_string(i));
  for (const auto& [a, b] : constrained) {
    DistanceConstraint constraint;
    constraint.between = {a, b};
    problem.constraints.push_back(constraint);
  }
  return problem;
}

/// Octahedron without the diagonals 0-3, 1-4 and 2-5: every point has four neighbours.
const Pairs octahedron = {{0, 1}, {0, 2}, {0, 4}, {0, 5}, {1, 2}, {1, 3},
                          {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}};

}  // namespace

TEST_CASE("what can be placed point by point leaves the reference") {
  const CoreReduction reduction = reduce_to_core(toy::instance().problem, {0, 1});
  CHECK(reduction.core_is_trivial);
  CHECK(reduction.core == std::vector<int>{0, 1});
  CHECK(reduction.core_constraints == std::vector<int>{0});
  REQUIRE(reduction.placed.size() == 2);
  CHECK(reduction.placed[0].from == std::vector<int>{0, 1});
}

TEST_CASE("a problem without a point that hangs on few others is its own core") {
  const CoreReduction reduction = reduce_to_core(problem_of(3, 6, 0, octahedron), {0, 1, 2});
  CHECK_FALSE(reduction.core_is_trivial);
  CHECK(reduction.core.size() == 6);
  CHECK(reduction.core_constraints.size() == 12);
  CHECK(reduction.placed.empty());
}

TEST_CASE("a chain of points is placed in the order in which they hang on each other") {
  Pairs constrained = octahedron;
  constrained.insert(constrained.end(), {{6, 0}, {6, 1}, {6, 2}, {7, 6}, {7, 0}, {7, 3}});
  const CoreReduction reduction = reduce_to_core(problem_of(3, 8, 0, constrained), {0, 1, 2});
  CHECK(reduction.core.size() == 6);
  REQUIRE(reduction.placed.size() == 2);
  CHECK(reduction.placed[0].point == 6);
  CHECK(reduction.placed[1].point == 7);
}

TEST_CASE("a reference point that hangs on others is placed like them when the core is elsewhere") {
  Pairs constrained = octahedron;
  constrained.insert(constrained.end(), {{6, 0}, {6, 1}, {6, 2}});
  const CoreReduction reduction = reduce_to_core(problem_of(3, 7, 0, constrained), {6, 0, 1});
  CHECK(reduction.core.size() == 6);
  REQUIRE(reduction.placed.size() == 1);
  CHECK(reduction.placed[0].point == 6);
}

TEST_CASE("points hang on a line as on a point, and a line is never placed") {
  // A tetrahedron, a line at four given distances from it, and point 4 that hangs on the line and two points.
  const Pairs constrained = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {0, 5},
                             {1, 5}, {2, 5}, {3, 5}, {4, 5}, {4, 0}, {4, 1}};
  const CoreReduction reduction = reduce_to_core(problem_of(3, 5, 1, constrained), {5, 0});
  REQUIRE(reduction.placed.size() == 1);
  CHECK(reduction.placed[0].point == 4);
  CHECK(reduction.placed[0].from == std::vector<int>{5, 0, 1});
  CHECK(reduction.core == std::vector<int>{0, 1, 2, 3, 5});
  CHECK_FALSE(reduction.core_is_trivial);
}

TEST_CASE("fixed positions need no rest") {
  ProblemStatement problem = problem_of(3, 4, 0, {{3, 0}, {3, 1}, {3, 2}});
  problem.fixed_points = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
                          std::nullopt};
  const CoreReduction reduction = reduce_to_core(problem, {});
  CHECK(reduction.core_is_trivial);
  CHECK(reduction.core == std::vector<int>{0, 1, 2});
  REQUIRE(reduction.placed.size() == 1);
  CHECK(reduction.placed[0].from == std::vector<int>{0, 1, 2});
}
