#pragma once
/// Problems for tests: two of the shipped ones, the graphs of three more, and random rigid ones.

#include <array>
#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs::samples {

using Edges = std::vector<std::array<int, 2>>;

/// Points named p1, p2, …; no sketch.
ProblemStatement problem_of(int dimension, int points, const Edges& edges,
                            const std::vector<double>& lengths);

/// Sketch and target lengths are those of two placements.
ProblemStatement between(int dimension, const Edges& edges, const Eigen::Matrix3Xd& sketch,
                         const Eigen::Matrix3Xd& target);

/// The running example of Imbach, Mathis, Schreck 2016 with the lengths of instances/k33.json.
ProblemStatement k33();
/// Their octahedron with the lengths of instances/octahedron.json.
ProblemStatement octahedron();

/// Constraints of the instances of that name.
Edges disulfide_edges();
Edges dodecagon_edges();
Edges icosahedron_edges();

/// All pairs of points that are in one body.
Edges edges_within(const std::vector<std::vector<int>>& bodies);

/// Rigid bodies in space in a ring, each hinged to the next by an edge that they share: body i is a triangle
/// where its two hinges meet in a point, otherwise a tetrahedron.
Edges hinged_ring_edges(const std::vector<bool>& meets);

/// A graph made by Henneberg's two steps from a simplex, hence generically rigid and without a redundant
/// edge.
Edges random_rigid_graph(int dimension, int points, RandomNumbers& random);
/// Such a graph with a random sketch and the lengths of another random placement.
ProblemStatement random_problem(int dimension, int points, RandomNumbers& random);

}  // namespace gcs::samples
