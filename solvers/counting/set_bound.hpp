#pragma once
/// How many places a set of elements has at most while others are held: see placed_sets (element_bound.hpp), of which this is
/// one step.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/numeric/disjoint_sets.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A constraint between two elements.
struct ElementEdge {
  std::array<int, 2> ends{};
  ElementPolynomials polynomials;
  bool shares_direction = false;
  bool is_beside = false;    ///< a distance of a line and a plane, which are parallel
  int sided = -1;            ///< a plane of which it sees a side
  bool joins_sides = false;  ///< two planes are turned over together, or neither
};

ElementEdge distance_edge(const ProblemStatement& problem, int a, int b);
/// Nothing where one is not between two elements.
std::optional<std::vector<ElementEdge>> edges_of(const ProblemStatement& problem);

/// The elements of a scene and the constraints between them.
struct ElementGraph {
  ElementGraph(const ProblemStatement& given, std::vector<ElementEdge> stated)
      : problem(given),
        edges(std::move(stated)),
        directions(given.entity_count()),
        sides(given.entity_count()) {
    for (const ElementEdge& edge : edges) {
      if (edge.shares_direction) directions.join(edge.ends[0], edge.ends[1]);
      if (edge.joins_sides) sides.join(edge.ends[0], edge.ends[1]);
    }
  }

  int freedoms(int entity) const {
    const int d = problem.dimension;
    return problem.is_point(entity) ? d : problem.is_line(entity) ? 2 * d - 2 : 3;
  }
  bool are_points(const std::array<int, 2>& ends) const {
    return problem.is_point(ends[0]) && problem.is_point(ends[1]);
  }

  const ProblemStatement& problem;
  std::vector<ElementEdge> edges;
  DisjointSets directions, sides;
};

/// By the constraints between `elements`, of which those `held` stay. Nothing where there are not as many equations as
/// freedoms, or counting takes more states than are left (see count_orientations).
std::optional<Natural> places_of_set(const ElementGraph& graph, const std::vector<int>& elements,
                                     const std::vector<int>& held, std::int64_t& states_left);

}  // namespace gcs
