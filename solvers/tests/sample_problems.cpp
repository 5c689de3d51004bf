#include "solvers/tests/sample_problems.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

namespace gcs::samples {
namespace {

std::string numbered(std::string letter, int number) { return letter.append(std::to_string(number)); }

ProblemStatement with_sketch(ProblemStatement problem, const std::vector<Eigen::Vector3d>& points) {
  Figure sketch;
  sketch.points.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) sketch.points.col(static_cast<Eigen::Index>(i)) = points[i];
  problem.sketch = sketch;
  return problem;
}

std::vector<int> some_of(int count, int total, RandomNumbers& random) {
  std::vector<int> all(static_cast<std::size_t>(total));
  std::iota(all.begin(), all.end(), 0);
  for (int i = 0; i < count; ++i) std::swap(all[i], all[i + random.index(total - i)]);
  all.resize(static_cast<std::size_t>(count));
  return all;
}

/// Henneberg's second step: an edge is replaced by a point joined to its ends and to dimension − 1 others.
void split_edge(Edges& edges, int dimension, int point, RandomNumbers& random) {
  const auto removed = edges.begin() + random.index(static_cast<int>(edges.size()));
  const auto [a, b] = *removed;
  edges.erase(removed);
  edges.push_back({a, point});
  edges.push_back({b, point});
  int wanted = dimension - 1;
  for (const int other : some_of(point, point, random)) {
    if (wanted == 0) break;
    if (other == a || other == b) continue;
    edges.push_back({other, point});
    --wanted;
  }
}

}  // namespace

ProblemStatement problem_of(int dimension, int points, const Edges& edges,
                            const std::vector<double>& lengths) {
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 1; i <= points; ++i) problem.points.push_back(numbered("p", i));
  for (const auto& edge : edges) {
    const int number = static_cast<int>(problem.constraints.size());
    problem.constraints.push_back({numbered("a", number + 1), edge, {lengths[number], ""}, false});
  }
  return problem;
}

ProblemStatement between(int dimension, const Edges& edges, const Eigen::Matrix3Xd& sketch,
                         const Eigen::Matrix3Xd& target) {
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const auto& [a, b] : edges) lengths.push_back((target.col(a) - target.col(b)).norm());
  ProblemStatement problem = problem_of(dimension, static_cast<int>(sketch.cols()), edges, lengths);
  problem.sketch = Figure{sketch, {}};
  return problem;
}

ProblemStatement k33() {
  const Edges edges{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {0, 3}, {1, 4}, {2, 5}};
  ProblemStatement problem = problem_of(2, 6, edges, {2.58, 1.85, 2.21, 1.76, 1.57, 2.13, 2.85, 3.11, 3.9});
  problem.reference = Reference{0, 1};
  return with_sketch(problem, {{0, 0, 0}, {2, 0, 0}, {3, 1.5, 0}, {2.2, 3, 0}, {0.3, 3.2, 0}, {-1, 1.7, 0}});
}

ProblemStatement octahedron() {
  const Edges edges{{0, 1}, {0, 2}, {0, 4}, {0, 5}, {1, 2}, {1, 3},
                    {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}};
  ProblemStatement problem =
      problem_of(3, 6, edges, {1.1, 1.3, 1.7, 1.6, 1.2, 1.8, 1.6, 1.7, 1.3, 1.9, 2.2, 2.7});
  problem.reference = Reference{0, 1, 2};
  return with_sketch(
      problem, {{0, 0, 0}, {1, 0, 0}, {0.5, 1.3, 0}, {1.2, 0.5, 1.5}, {0, 1.8, 0.9}, {-0.2, -0.7, 1.3}});
}

Edges disulfide_edges() {
  return {{0, 1}, {0, 6}, {0, 7}, {1, 6}, {1, 7}, {6, 7}, {2, 3}, {2, 4}, {2, 5},
          {3, 4}, {3, 5}, {4, 5}, {1, 2}, {0, 2}, {1, 3}, {5, 6}, {4, 6}, {5, 7}};
}

Edges dodecagon_edges() {
  return {{0, 1},  {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6},  {6, 7},  {7, 8}, {8, 9}, {9, 10}, {10, 11},
          {11, 0}, {0, 3}, {2, 5}, {4, 7}, {6, 9}, {8, 11}, {10, 1}, {0, 6}, {2, 8}, {4, 10}};
}

Edges icosahedron_edges() {
  return {{0, 1},  {1, 3},  {3, 2}, {2, 5}, {5, 4},  {4, 7},  {7, 8},  {8, 9},  {9, 11}, {11, 10},
          {10, 1}, {10, 6}, {3, 6}, {5, 6}, {7, 6},  {9, 6},  {10, 3}, {10, 9}, {9, 7},  {7, 5},
          {5, 3},  {1, 2},  {2, 4}, {4, 8}, {8, 11}, {11, 1}, {0, 8},  {0, 4},  {0, 2},  {0, 11}};
}

Edges edges_within(const std::vector<std::vector<int>>& bodies) {
  std::set<std::array<int, 2>> edges;
  for (const std::vector<int>& body : bodies)
    for (const int a : body)
      for (const int b : body)
        if (a < b) edges.insert({a, b});
  return {edges.begin(), edges.end()};
}

Edges hinged_ring_edges(const std::vector<bool>& meets) {
  const int bodies = static_cast<int>(meets.size());
  std::vector<std::array<int, 2>> hinges;
  int points = 0;
  for (int i = 0; i < bodies; ++i) {
    const int start = i > 0 && meets[i - 1] ? hinges.back()[1] : points++;
    hinges.push_back({start, points++});
  }
  if (meets.back()) hinges.back()[1] = hinges.front()[0];
  std::vector<std::vector<int>> all;
  for (int i = 0; i < bodies; ++i) {
    const auto &hinge = hinges[i], &next = hinges[(i + 1) % bodies];
    all.push_back({hinge[0], hinge[1], next[0], next[1]});
  }
  return edges_within(all);
}

Edges random_rigid_graph(int dimension, int points, RandomNumbers& random) {
  Edges edges;
  for (int a = 0; a < dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) edges.push_back({a, b});
  for (int point = dimension; point < points; ++point) {
    if (point > dimension && random.sign() > 0) {
      split_edge(edges, dimension, point, random);
      continue;
    }
    for (const int other : some_of(dimension, point, random)) edges.push_back({other, point});
  }
  return edges;
}

ProblemStatement random_problem(int dimension, int points, RandomNumbers& random) {
  const Edges edges = random_rigid_graph(dimension, points, random);
  const Eigen::Matrix3Xd sketch = random.points(dimension, points, 2);
  return between(dimension, edges, sketch, random.points(dimension, points, 2));
}

}  // namespace gcs::samples
