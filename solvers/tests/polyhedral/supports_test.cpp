#include "solvers/polyhedral/supports.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/lanes/square_system.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/polyhedral/mixed_cells.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::Edges;

namespace {

Natural mixed_volume(const Supports& supports) {
  const MixedCells cells = mixed_cells(supports, {1, 1, {}});
  REQUIRE(cells.status == MixedCellStatus::complete);
  return cells.total_volume();
}

ProblemStatement graph(int dimension, int points, const Edges& edges, const Reference& reference) {
  ProblemStatement problem =
      samples::problem_of(dimension, points, edges, std::vector<double>(edges.size(), 1.0));
  problem.reference = reference;
  return problem;
}

ComplexVectorX random_placement(const DistanceSystem& system) {
  std::mt19937_64 random(7);
  return random_complex_vector(system.unknowns(), random);
}

Supports coordinate_supports(const DistanceSystem& system) {
  return coordinate_equations(square_system(system), random_placement(system)).supports;
}

Supports sphere_supports(const DistanceSystem& system) {
  return sphere_equations(system, random_placement(system)).supports;
}

Natural coordinate_volume(const ProblemStatement& problem) {
  return mixed_volume(coordinate_supports(DistanceSystem(Scene(problem))));
}

Natural sphere_volume(const ProblemStatement& problem) {
  return mixed_volume(sphere_supports(DistanceSystem(Scene(problem))));
}

/// The terms of equation e at y.
ComplexVectorX terms_at(const SparseEquations& equations, std::size_t e, const ComplexVectorX& y) {
  ComplexVectorX terms;
  for (std::size_t j = 0; j < equations.supports[e].size(); ++j) {
    std::complex<double> term = equations.coefficients[e][j];
    for (std::size_t v = 0; v < y.size(); ++v)
      for (int i = 0; i < equations.supports[e][j][v]; ++i) term *= y[v];
    terms.push_back(term);
  }
  return terms;
}

/// Largest sum of an equation's terms relative to the largest term, at the placement x and its s_j.
double relative_residual(const SparseEquations& equations, const ComplexVectorX& x) {
  const std::size_t n = equations.supports.size();
  ComplexVectorX y(n);
  std::vector<bool> is_coordinate(n, false);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (equations.unknown_of[i] < 0) continue;
    y[equations.unknown_of[i]] = x[i];
    is_coordinate[equations.unknown_of[i]] = true;
  }
  for (std::size_t v = 0, e = 0; v < n; ++v) {
    if (is_coordinate[v]) continue;
    for (const std::complex<double>& term : terms_at(equations, e, y)) y[v] -= term;
    ++e;
  }
  double worst = 0;
  for (std::size_t e = 0; e < n; ++e) {
    std::complex<double> sum = 0;
    const ComplexVectorX terms = terms_at(equations, e, y);
    for (const std::complex<double>& term : terms) sum += term;
    worst = std::max(worst, std::abs(sum) / largest(terms));
  }
  return worst;
}

/// With the problem's own reference held fixed, and with what is at infinity at all lengths, as mixed volumes have it.
Natural bezout_bound(const ProblemStatement& problem) {
  BoundProblem bound{problem.dimension, {}, std::vector<bool>(problem.points.size(), false), {}};
  bound.are_points = false;
  for (const DistanceConstraint& constraint : problem.constraints) bound.edges.push_back(constraint.between);
  std::vector<int>& reference = bound.references.emplace_back();
  for (const int point : {problem.reference->origin, problem.reference->axis, problem.reference->plane})
    if (point >= 0) reference.push_back(point);
  return smallest_bezout_bound(bound)->fixed_frame;
}

const Edges prism_edges{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};

}  // namespace

TEST_CASE("monomials of a triangle in the plane") {
  const DistanceSystem system(Scene(graph(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {0, 1})));
  // Unknowns: x of p2, then x and y of p3.
  CHECK(coordinate_supports(system) == Supports{{{2, 0, 0}, {0, 0, 0}},
                                                {{0, 2, 0}, {0, 0, 2}, {0, 0, 0}},
                                                {{2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 0, 2}, {0, 0, 0}}});
  // Unknowns: x, y and s of p3.
  CHECK(sphere_supports(system) == Supports{{{0, 0, 1}, {2, 0, 0}, {0, 2, 0}},
                                            {{0, 0, 1}, {0, 0, 0}},
                                            {{0, 0, 1}, {1, 0, 0}, {0, 0, 0}}});
}

TEST_CASE("a reference whose distance is not given stays unknown among the spheres") {
  // Two triangles on the edge of p2 and p3; p1 and p4, the reference, are their other points.
  const DistanceSystem system(Scene(graph(2, 4, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, {0, 3})));
  // Unknowns: x, y, s of p2, then of p3, then x and s of p4. The origin p1 is known.
  const Supports supports = sphere_supports(system);
  REQUIRE(supports.size() == 8);
  CHECK(supports[2] == Support{{0, 0, 0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 0, 2, 0}});
  CHECK(supports[6] == Support{{0, 0, 1, 0, 0, 0, 0, 0},
                               {0, 0, 0, 0, 0, 0, 0, 1},
                               {1, 0, 0, 0, 0, 0, 1, 0},
                               {0, 0, 0, 0, 0, 0, 0, 0}});
}

TEST_CASE("spheres of points that the file fixes") {
  ProblemStatement problem = samples::problem_of(2, 3, {{0, 2}, {1, 2}}, {2, 2});
  problem.fixed_points = {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), std::nullopt};
  CHECK(sphere_supports(DistanceSystem(Scene(problem))) == Supports{{{0, 0, 1}, {2, 0, 0}, {0, 2, 0}},
                                                                    {{0, 0, 1}, {1, 0, 0}, {0, 0, 0}},
                                                                    {{0, 0, 1}, {0, 1, 0}, {0, 0, 0}}});
  CHECK(sphere_volume(problem) == Natural(2));
}

// In the coordinates themselves the mixed volume is Bézout's number 2^m.
TEST_CASE("coordinates have the total degree") {
  CHECK(coordinate_volume(samples::k33()) == Natural::power_of_two(9));
  CHECK(coordinate_volume(graph(2, 6, prism_edges, {0, 1})) == Natural::power_of_two(9));
  CHECK(coordinate_volume(samples::octahedron()) == Natural(4096));
}

// Bartzos, Emiris and Schicho 2020 give 16 for the octahedron.
TEST_CASE("spheres meet the multihomogeneous bound of the octahedron and the disulfide bond") {
  CHECK(sphere_volume(samples::octahedron()) == Natural(16));
  const ProblemStatement disulfide = graph(3, 8, samples::disulfide_edges(), {0, 7, 1});
  CHECK(sphere_volume(disulfide) == Natural(128));
  CHECK(bezout_bound(disulfide) == Natural(128));
}

// At generic lengths all solutions are isolated and no coordinate is 0, so that Bernshtein's bound holds for
// them; every point's coordinates and s as one group make Bézout's bound one of polytopes that contain these.
TEST_CASE("the mixed volume of spheres is between the number of solutions and the multihomogeneous bound") {
  samples::RandomNumbers random(3);
  std::vector<ProblemStatement> problems{samples::k33(), graph(2, 6, prism_edges, {0, 1})};
  for (int i = 0; i < 12; ++i) {
    const Edges edges = samples::random_rigid_graph(2, 7, random);
    problems.push_back(graph(2, 7, edges, {edges[0][0], edges[0][1]}));
  }
  for (const ProblemStatement& problem : problems) {
    const Natural volume = sphere_volume(problem);
    CHECK(volume <= bezout_bound(problem));
    CHECK(volume >= theoretical_counts(problem).exact->fixed_frame);
  }
}

TEST_CASE("both formulations vanish at the placement whose lengths they have") {
  ProblemStatement fixed = samples::problem_of(2, 4, {{0, 2}, {1, 3}, {2, 3}, {1, 2}}, {2, 2, 2, 2});
  fixed.fixed_points = {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, 1, 0), std::nullopt, std::nullopt};
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron(), fixed}) {
    const DistanceSystem system((Scene(problem)));
    const ComplexVectorX x = random_placement(system);
    CHECK(relative_residual(coordinate_equations(square_system(system), x), x) < 1e-14);
    CHECK(relative_residual(sphere_equations(system, x), x) < 1e-14);
    ComplexVectorX moved = x;
    moved.back() += 1e-6;
    CHECK(relative_residual(coordinate_equations(square_system(system), x), moved) > 1e-9);
  }
}
