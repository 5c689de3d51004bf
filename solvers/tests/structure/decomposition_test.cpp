#include "solvers/structure/decomposition.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "solvers/structure/structure.hpp"
#include "solvers/tests/grown_graphs.hpp"

using namespace gcs;
using samples::Graph;
using samples::RandomNumbers;

namespace {

ProblemStatement problem_of(const Graph& graph) {
  return samples::problem_of(graph.dimension, graph.points, graph.edges,
                             std::vector<double>(graph.edges.size(), 1.0));
}

std::ptrdiff_t solved_parts(const std::vector<Part>& parts) {
  return std::count_if(parts.begin(), parts.end(), [](const Part& part) { return !part.is_hung_point(); });
}

/// Every point is placed once, on d points that are there; a part with several points is rigid on its own.
void check_parts(const ProblemStatement& problem, const std::vector<Part>& parts) {
  std::set<int> placed, constraints;
  for (const Part& part : parts) {
    CHECK(part.base.size() == (placed.empty() ? 0U : static_cast<std::size_t>(problem.dimension)));
    for (const int point : part.base) CHECK(placed.count(point) == 1);
    for (const int point : part.points) CHECK(placed.insert(point).second);
    constraints.insert(part.constraints.begin(), part.constraints.end());
    for (std::size_t i = 0; part.is_hung_point() && i < part.base.size(); ++i) {
      const std::set<int> ends{part.base[i], part.points.front()};
      const auto& between = problem.constraints[part.constraints.at(i)].between;
      CHECK(std::set<int>{between[0], between[1]} == ends);
    }
    if (!part.is_hung_point()) CHECK(analyse_structure(part_problem(problem, part).problem).well_posed());
  }
  CHECK(placed.size() == problem.points.size());
  CHECK(constraints.size() == problem.constraints.size());
}

}  // namespace

TEST_CASE("what nothing separates is one part") {
  for (const Graph& graph : {samples::octahedron_graph(), samples::k33_graph()}) {
    const auto parts = decompose(problem_of(graph), Split::all);
    REQUIRE(parts.size() == 1);
    CHECK(parts.front().points.size() == 6);
    CHECK(parts.front().constraints.size() == graph.edges.size());
  }
}

TEST_CASE("scenes fall into their parts, whatever the order of the points") {
  RandomNumbers random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Graph graph = samples::chain_of_octahedra(1 + trial % 4);
    const int hung = random.index(6);
    samples::hang_at_random(graph, hung, 0, random);
    const ProblemStatement problem = problem_of(samples::relabelled(graph, random));
    const auto parts = decompose(problem, Split::all);
    check_parts(problem, parts);
    CHECK(solved_parts(parts) == 1 + trial % 4);
    CHECK(static_cast<int>(parts.size()) == 1 + trial % 4 + hung);
    CHECK(solved_parts(decompose(problem, Split::hung_points)) == 1);
  }
}

TEST_CASE("a triangle that three octahedra share joins them all") {
  const Graph octahedron = samples::chain_of_octahedra(1);
  const ProblemStatement problem =
      problem_of(glued(glued(octahedron, octahedron, {0, 1, 2}), octahedron, {0, 1, 2}));
  const auto parts = decompose(problem, Split::all);
  check_parts(problem, parts);
  CHECK(solved_parts(parts) == 3);
}

TEST_CASE("in the plane an edge separates") {
  const Graph k33 = samples::k33_graph();
  const auto [a, b] = k33.edges.front();
  const ProblemStatement problem = problem_of(glued(k33, k33, {a, b}));
  const auto parts = decompose(problem, Split::all);
  check_parts(problem, parts);
  CHECK(solved_parts(parts) == 2);
}

TEST_CASE("a simplex between two cores is placed by the distances of its point") {
  RandomNumbers random(3);
  const auto [a, b] = samples::k33_graph().edges.front();
  const std::array graphs{samples::with_simplex_between(samples::k33_graph(), {a, b}),
                          samples::with_simplex_between(samples::chain_of_octahedra(1), {0, 1, 2})};
  for (int trial = 0; trial < 20; ++trial) {
    const ProblemStatement problem = problem_of(samples::relabelled(graphs[trial % 2], random));
    const auto parts = decompose(problem, Split::all);
    check_parts(problem, parts);
    CHECK(parts.size() == 3);
  }
}

TEST_CASE("what can be placed one by one leaves five points to solve") {
  Graph graph{3, 3, {{0, 1}, {0, 2}, {1, 2}}};
  RandomNumbers random(2);
  samples::hang_at_random(graph, 20, 0, random);
  const auto parts = decompose(problem_of(graph), Split::all);
  check_parts(problem_of(graph), parts);
  CHECK(parts.front().points.size() == 5);
  CHECK(parts.size() == 19);
}

TEST_CASE("given positions are not taken apart") {
  ProblemStatement problem = problem_of(samples::chain_of_octahedra(2));
  problem.fixed_points.resize(problem.points.size());
  problem.fixed_points[0] = Eigen::Vector3d::Zero();
  CHECK(decompose(problem, Split::all).size() == 1);
}

TEST_CASE("a part has the bends of its own constraints, and those alone") {
  ProblemStatement problem = problem_of(samples::chain_of_octahedra(2));
  problem.interpolation.bends.emplace();
  for (int i = 0; i < static_cast<int>(problem.constraints.size()); i += 2)
    problem.interpolation.bends->push_back({i, {static_cast<double>(i), 0.5}});
  for (const Part& part : decompose(problem, Split::all)) {
    const PartProblem alone = part_problem(problem, part);
    std::set<std::string> bent;
    for (const BentLength& length : *alone.problem.interpolation.bends) {
      const std::string& id = alone.problem.constraints[length.constraint].id;
      bent.insert(id);
      const auto whole = std::ranges::find(problem.constraints, id, &DistanceConstraint::id);
      CHECK(length.coefficients ==
            std::vector<double>{static_cast<double>(whole - problem.constraints.begin()), 0.5});
    }
    std::set<std::string> expected;
    for (const int i : part.constraints)
      if (i % 2 == 0) expected.insert(problem.constraints[i].id);
    CHECK(bent == expected);
  }
  problem.interpolation.bends->clear();
  const PartProblem alone = part_problem(problem, decompose(problem, Split::all).front());
  CHECK(alone.problem.interpolation.bends->empty());
}
