/// [S] is Gallet, Grasegger, Schicho: Counting realizations of Laman graphs on the sphere, 2020.

#include "solvers/counting/sphere_count.hpp"

#include <bit>
#include <catch2/catch.hpp>

#include "solvers/counting/cross_ratio_count.hpp"
#include "solvers/counting/laman_graphs.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

const GraphEdges prism{{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}, {0, 3}, {1, 4}, {2, 5}};
const GraphEdges k33{{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}};

Natural on_sphere(const GraphEdges& edges) { return count_on_sphere(edges, {}).value(); }

/// Of a graph on the points 0, 1, …, two marks for each.
CrossRatios ratios_of(const GraphEdges& edges, int points) {
  CrossRatios ratios{2 * points, {}};
  for (const auto& [a, b] : edges) ratios.quadruples.push_back(MarkSet{3} << 2 * a | MarkSet{3} << 2 * b);
  return ratios;
}

/// The marks of one line of two, packed, with the one in which it meets the other as the last.
CrossRatios line_with(const CrossRatios& ratios, MarkSet marks) {
  CrossRatios line;
  std::vector<MarkSet> name(static_cast<std::size_t>(ratios.marks), 0);
  for (int mark = 0; mark < ratios.marks; ++mark)
    if ((marks >> mark & 1) != 0) name[static_cast<std::size_t>(mark)] = MarkSet{1} << line.marks++;
  for (std::size_t q = 1; q < ratios.quadruples.size(); ++q) {
    const MarkSet here = ratios.quadruples[q] & marks;
    if (std::popcount(here) < 3) continue;
    MarkSet renamed = std::popcount(here) == 3 ? MarkSet{1} << line.marks : 0;
    for (int mark = 0; mark < ratios.marks; ++mark)
      if ((here >> mark & 1) != 0) renamed |= name[static_cast<std::size_t>(mark)];
    line.quadruples.push_back(renamed);
  }
  ++line.marks;
  return line;
}

/// The recursion of [S] for the first quadruple, its two lowest marks on one line: all distributions, no memory, nothing
/// simplified.
std::uint64_t number_as_printed(const CrossRatios& ratios) {
  if (static_cast<int>(ratios.quadruples.size()) != ratios.marks - 3) return 0;
  if (ratios.quadruples.empty()) return 1;
  const MarkSet first = ratios.quadruples[0], all = (MarkSet{1} << ratios.marks) - 1;
  const MarkSet low = (first & -first) | ((first & (first - 1)) & -(first & (first - 1)));
  std::uint64_t sum = 0;
  for (MarkSet marks = 0; marks <= all; ++marks) {
    bool can_count = (marks & first) == low;
    for (std::size_t q = 1; can_count && q < ratios.quadruples.size(); ++q)
      can_count = std::popcount(ratios.quadruples[q] & marks) != 2;
    if (!can_count) continue;
    const std::uint64_t here = number_as_printed(line_with(ratios, marks));
    if (here != 0) sum += here * number_as_printed(line_with(ratios, all & ~marks));
  }
  return sum;
}

}  // namespace

TEST_CASE("realisations of small graphs on the sphere") {
  CHECK(on_sphere({{0, 1}}) == Natural(1));
  CHECK(on_sphere({{0, 1}, {0, 2}, {1, 2}}) == Natural(2));
  CHECK(on_sphere(prism) == Natural(32));  // [S]
  CHECK(on_sphere(k33) == Natural(16));    // [S]
}

TEST_CASE("the recursion over cross ratios gives what its printed form gives") {
  for (const int points : {2, 3, 4, 5, 6})
    for (const GraphEdges& edges : all_laman_graphs(points)) {
      const CrossRatios ratios = ratios_of(edges, points);
      CHECK(CrossRatioCounter({}).count(ratios) == number_as_printed(ratios));
      CHECK(on_sphere(edges) == Natural(number_as_printed(ratios)));
    }
}

// Dewar, Grasegger: The number of realisations of a rigid graph in Euclidean and spherical geometries, 2024.
TEST_CASE("there are at least as many realisations on the sphere as in the plane") {
  int more = 0;
  for (const int points : {6, 7, 8})
    for (const GraphEdges& edges : all_laman_graphs(points)) {
      const Natural in_plane = count_in_plane(edges, {}).value();
      CHECK_FALSE(on_sphere(edges) < in_plane);
      more += in_plane < on_sphere(edges);
    }
  CHECK(more > 10);
  samples::RandomNumbers random(2020);
  for (int i = 0; i < 10; ++i) {
    const GraphEdges edges = samples::random_rigid_graph(2, 14, random);
    CHECK_FALSE(on_sphere(edges) < count_in_plane(edges, {}).value());
  }
}

TEST_CASE("on the sphere parts that share two points multiply as the recursion for the whole says") {
  for (const GraphEdges& edges : all_laman_graphs(7))
    CHECK(on_sphere(edges) == Natural(CrossRatioCounter({}).count(ratios_of(edges, 7)).value()));
}

TEST_CASE("a scene of the plane is counted on the sphere, with points that hang on it") {
  ProblemStatement problem = samples::k33();
  CHECK(sphere_count(problem).exact->fixed_frame == Natural(16));
  CHECK(sphere_count(problem).exact->up_to_reflection() == Natural(8));
  const samples::Edges chain{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 4}};
  const ProblemStatement hung = samples::problem_of(2, 5, chain, std::vector<double>(chain.size(), 1.0));
  CHECK(sphere_count(hung).exact->fixed_frame == Natural(8));
  CHECK_THAT(sphere_count(samples::octahedron()).why_no_exact, Catch::Contains("plane"));
  CHECK_THAT(sphere_count(problem, {.steps = 1}).why_no_exact, Catch::Contains("more than the 1 steps"));
}
