#include "solvers/homotopies/monodromy_search.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "solvers/counting/laman_graphs.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/trace_test.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tests/laman_graphs.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;

namespace {

const auto never = [] { return false; };

/// Everything that a search and a homotopy need, for one problem.
struct Setting {
  explicit Setting(const ProblemStatement& problem, std::uint64_t seed = 1, int threads = 1)
      : random(seed),
        scene(Scene::unchecked(problem)),
        coordinates(scene),
        system(square_system(coordinates)),
        elimination(order_elimination(system, random)),
        tracking(system, elimination, {{}, widest_instruction_set(), threads}) {}

  GenericSolutions search(std::optional<std::uint64_t> count, const MonodromyOptions& options = {}) {
    return search_by_monodromy(
        all_lengths(system, mirror_axes(scene, coordinates)), tracking, {count, nullptr}, options, random,
        never, [](int) {}, work);
  }

  TraceTest trace(int arcs) {
    MonodromyOptions options;
    options.bend = 8;
    options.arcs = arcs;
    return test_trace(
        system, mirror_axes(scene, coordinates), {{}, widest_instruction_set(), 1}, options, random, never,
        [](int) {}, work);
  }

  std::vector<PathEnd> ends(
      const GenericSolutions& generic, const std::function<void(double)>& progress = [](double) {}) {
    ComplexVectorX squares;
    for (const DoubleDouble& square : target_squares(scene)) squares.push_back(square.value());
    const auto is_zero = [&](const ComplexVectorX& x) { return is_zero_at(system, squares, x); };
    return follow_to_end(tracking, generic.solutions, generic.squares, squares, is_zero, never, progress,
                         work);
  }

  SolveReport report(const std::vector<PathEnd>& ends) {
    return complex_report(scene, coordinates, ends, work, random, {});
  }

  std::mt19937_64 random;
  Scene scene;
  DistanceSystem coordinates;
  SquareSystem system;
  Elimination elimination;
  LegTracking tracking;
  WorkCounters work;
};

int number_of(const std::vector<PathEnd>& ends, PathEnd::Kind kind) {
  int count = 0;
  for (const PathEnd& end : ends) count += end.kind == kind;
  return count;
}

ProblemStatement with_unit_lengths(int dimension, int points, const samples::Edges& edges) {
  return samples::problem_of(dimension, points, edges, std::vector<double>(edges.size(), 1.0));
}

/// Legs for each of so many classes, all of which are found: the mean of some seeds. All but the first and its conjugate need
/// one at least.
double legs_for_each(const ProblemStatement& problem, std::uint64_t classes) {
  const int seeds = repetitions(4);
  std::int64_t legs = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const GenericSolutions found = Setting(problem, static_cast<std::uint64_t>(seed)).search(classes);
    CHECK(found.end == SearchEnd::complete);
    legs += found.legs;
  }
  CHECK(legs >= seeds * (static_cast<std::int64_t>(classes) - 2));
  return static_cast<double>(legs) / (seeds * static_cast<double>(classes));
}

}  // namespace

TEST_CASE("loops find as many solutions as there are, from any seed") {
  // Capco et al. 2018 for the plane (fixed frame: 16 and 24), Bartzos et al. 2020 for the octahedron (16).
  const samples::Edges prism{{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}};
  const std::vector<double> lengths(9, 1.0);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CHECK(Setting(samples::k33(), seed).search(std::nullopt).solutions.size() == 8);
    CHECK(Setting(samples::problem_of(2, 6, prism, lengths), seed).search(std::nullopt).solutions.size() ==
          12);
    CHECK(Setting(samples::octahedron(), seed).search(std::nullopt).solutions.size() == 8);
  }
}

TEST_CASE("loops find as many solutions as the bound of a ring of hinged bodies allows") {
  // The bound is met at generic lengths where no three hinges meet (ring_bound_test.cpp).
  const std::vector<std::vector<bool>> patterns{{true, true, true, false, false, true},
                                                {false, true, false, true, true, false}};
  for (const std::vector<bool>& meets : patterns) {
    const samples::Edges edges = samples::hinged_ring_edges(meets);
    const int points = 6 + static_cast<int>(std::count(meets.begin(), meets.end(), false));
    const ProblemStatement problem = with_unit_lengths(3, points, edges);
    const auto counts = theoretical_counts(problem);
    REQUIRE(counts.bound);
    REQUIRE(counts.bound->ring.size() == 6);
    CHECK(Natural(Setting(problem).search(std::nullopt).solutions.size()) ==
          counts.bound->count.up_to_reflection());
  }
}

TEST_CASE("three legs at most, or hardly more, find each solution of a graph with many") {
  // A pair of conjugates needs two at least, one to another node and one back. Half as many classes as realisations.
  for (const samples::RecordGraph& graph : samples::record_graphs) {
    if (graph.points < 9 || graph.points > 10) continue;
    const double legs = legs_for_each(
        with_unit_lengths(2, graph.points, graph_of_code(graph.points, graph.code)), graph.realisations / 2);
    CHECK(legs < 3.2);
  }
}

TEST_CASE("hardly more than two legs find each solution of a triangulated sphere in space") {
  // A random one of ten points, whose count is its m-Bézout bound. Random matchings and conjugates need 2.05.
  const GraphEdges edges{{0, 2}, {0, 4}, {0, 6}, {0, 9}, {1, 2}, {1, 4}, {1, 7}, {1, 9},
                         {2, 3}, {2, 6}, {2, 7}, {2, 8}, {2, 9}, {3, 4}, {3, 5}, {3, 6},
                         {3, 8}, {4, 5}, {4, 6}, {4, 7}, {4, 9}, {5, 7}, {5, 8}, {7, 8}};
  const double legs = legs_for_each(with_unit_lengths(3, 10, edges), 576);
  CHECK(legs < 2.3);
}

TEST_CASE("lengths at random are real in the plane, and real and imaginary in space") {
  const auto negative_ones = [](const ProblemStatement& problem, std::uint64_t seed) {
    const GenericSolutions generic = Setting(problem, seed).search(8);
    std::ptrdiff_t negative = 0;
    for (const std::complex<double>& square : generic.squares)
      negative += (square / generic.squares[0]).real() < 0 ? 1 : 0;
    return negative;
  };
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CHECK(negative_ones(samples::k33(), seed) == 0);
    CHECK(negative_ones(samples::octahedron(), seed) > 0);
  }
}

TEST_CASE("solutions at random lengths are those of real ones, turned") {
  Setting setting(samples::octahedron());
  const GenericSolutions generic = setting.search(8);
  const std::complex<double> turn = std::sqrt(generic.squares[0] / std::abs(generic.squares[0]));
  CHECK(std::abs(turn.imag()) > 1e-3);
  for (const std::complex<double>& square : generic.squares)
    CHECK(std::abs((square / (turn * turn)).imag()) <= 1e-14 * std::abs(square));
  SolutionSet set(mirror_axes(setting.scene, setting.coordinates), setting.random);
  for (ComplexVectorX x : generic.solutions) {
    for (std::complex<double>& value : x) value = std::conj(value / turn) * turn;
    set.insert(x, 1e-10);
  }
  for (const ComplexVectorX& x : generic.solutions) CHECK(set.find(x, 1e-10) >= 0);
}

TEST_CASE("a search that meets the count stops, and one that finds more is inconsistent") {
  CHECK(Setting(samples::octahedron()).search(8).end == SearchEnd::complete);
  CHECK(Setting(samples::octahedron()).search(9).end == SearchEnd::quiet);
  int inconsistent = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const GenericSolutions found = Setting(samples::octahedron(), seed).search(6);
    CHECK(found.end == (found.solutions.size() == 6 ? SearchEnd::complete : SearchEnd::inconsistent));
    inconsistent += found.end == SearchEnd::inconsistent ? 1 : 0;
  }
  CHECK(inconsistent > 0);
}

TEST_CASE("solutions that meet far from the lengths of all members are found") {
  // A point at squared distances A and B, both about 1, from (0, 0) and (3, 0). The two solutions meet where the triangle is
  // flat: √A + √B = 3.
  constexpr double apart = 3;
  SquareSystem system;
  system.unknowns = 2;
  system.add_equation({{0, -1, 0}, {1, -1, 0}}, {}, 0);
  system.add_equation({{0, -1, apart}, {1, -1, 0}}, {}, 0);
  const auto random_point = [](std::mt19937_64& random) {
    ComplexVectorX squares = random_complex_vector(2, random);
    for (std::complex<double>& square : squares) square = 1.0 + 0.1 * square;
    const std::complex<double> x = (squares[0] - squares[1] + apart * apart) / (2 * apart);
    return ComplexVectorX{x, std::sqrt(squares[0] - x * x)};
  };
  const HomotopyFamily family = square_family(system, {-1, -1}, {true, true}, random_point);
  MonodromyOptions options;
  options.arcs = 60;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::mt19937_64 random(seed);
    const Elimination elimination = order_elimination(system, random);
    LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
    WorkCounters work;
    const GenericSolutions found = search_by_monodromy(
        family, tracking, {2, nullptr}, options, random, never, [](int) {}, work);
    CHECK(found.end == SearchEnd::complete);
  }
}

TEST_CASE("the solutions found solve the equations and are distinct") {
  Setting setting(samples::octahedron());
  const GenericSolutions generic = setting.search(std::nullopt);
  for (const ComplexVectorX& x : generic.solutions) {
    const ComplexVectorX squares = squares_at(setting.system, x);
    for (std::size_t e = 0; e < squares.size(); ++e)
      CHECK(std::abs(squares[e] - generic.squares[e]) <= 1e-11 * (1 + std::abs(squares[e])));
  }
}

TEST_CASE("a trace test finds the counts that are known") {
  // Sources as above.
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()}) {
      const TraceTest test = Setting(problem, seed).trace(24);
      CHECK(test.passed());
      CHECK(test.solutions == 8);
    }
  }
}

TEST_CASE("a trace test does not pass on a part of the fibre") {
  // One arc leads to one orbit of its loops, and these are none.
  const TraceTest test = Setting(samples::octahedron()).trace(1);
  CHECK_FALSE(test.passed());
  CHECK(test.points < Setting(samples::octahedron()).trace(24).points);
  CHECK(test.defect > 1e-6);
}

TEST_CASE("threads change no bit of a search") {
  const GenericSolutions one = Setting(samples::octahedron(), 7, 1).search(std::nullopt);
  const GenericSolutions two = Setting(samples::octahedron(), 7, 2).search(std::nullopt);
  CHECK(one.solutions == two.solutions);
}

TEST_CASE("reflections of a solution are one solution, its conjugate is another") {
  Setting setting(samples::octahedron());
  SolutionSet set(mirror_axes(setting.scene, setting.coordinates), setting.random);
  const ComplexVectorX x = random_complex_vector(setting.system.unknowns, setting.random);
  const std::vector<int> axes = mirror_axes(setting.scene, setting.coordinates);
  CHECK(set.insert(x, 0) == 0);
  for (int reflection = 1; reflection < 8; ++reflection) {
    ComplexVectorX image = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (reflection >> axes[i] & 1) image[i] = -image[i];
    CHECK(set.find(image, 0) == 0);
    image[4] += 1e-6;
    CHECK(set.find(image, 0) == -1);
    CHECK(set.find(image, 1e-5) == 0);
  }
  ComplexVectorX conjugate = x;
  for (std::complex<double>& value : conjugate) value = std::conj(value);
  CHECK(set.find(conjugate, 0) == -1);
}

TEST_CASE("a flat triangle is a singular end of winding number 2") {
  Setting setting(samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {3, 1, 2}));
  const std::vector<PathEnd> ends = setting.ends(setting.search(std::nullopt));
  REQUIRE(ends.size() == 1);
  CHECK(ends[0].kind == PathEnd::Kind::singular);
  CHECK(ends[0].winding_number == 2);
  CHECK(setting.report(ends).paths.front().winding_number == 2);
  CHECK(setting.report(ends).paths.front().pole_order == 0);
  const Figure figure = setting.report(ends).candidates.front().figure;
  const Figure flat = setting.scene.in_file_unit(setting.scene.representative(figure));
  CHECK(flat.points(0, 2) == Approx(1).margin(1e-8));
  CHECK(flat.points(1, 2) == Approx(0).margin(1e-8));
}

namespace {

/// theory.md names the octahedron's condition: the edges from 2 to 3, 3 to 5, 5 to 6 and 6 to 2 form a closed walk whose
/// lengths are ±a23 ± a35 = ±a26 ± a56.
ProblemStatement escaping_octahedron() {
  ProblemStatement problem = samples::octahedron();
  const auto length = [&](int a, int b) -> double& {
    for (DistanceConstraint& c : problem.constraints)
      if ((c.between[0] == a && c.between[1] == b) || (c.between[0] == b && c.between[1] == a))
        return c.given.value;
    throw std::logic_error("no such edge");
  };
  length(1, 2) = length(1, 5) + length(4, 5) - length(2, 4);
  return problem;
}

}  // namespace

TEST_CASE("lengths whose signed sum vanishes send paths to infinity") {
  Setting setting(escaping_octahedron());
  const std::vector<PathEnd> ends = setting.ends(setting.search(8));
  CHECK(number_of(ends, PathEnd::Kind::at_infinity) > 0);
  CHECK(number_of(ends, PathEnd::Kind::at_infinity) + number_of(ends, PathEnd::Kind::regular) == 8);
  const SolveReport report = setting.report(ends);
  CHECK(report.status == SolveStatus::complete);
  for (const PathRecord& path : report.paths) {
    const bool escaped = path.end == PathRecord::End::at_infinity;
    CHECK((path.pole_order > 0) == escaped);
    CHECK(path.winding_number > 0);
  }
}

TEST_CASE("paths that do not simply arrive are halfway where they are walked around") {
  Setting setting(escaping_octahedron());
  std::vector<double> reports;
  const std::vector<PathEnd> ends =
      setting.ends(setting.search(8), [&](double done) { reports.push_back(done); });
  REQUIRE(number_of(ends, PathEnd::Kind::at_infinity) > 0);
  REQUIRE(reports.size() > 3);
  CHECK(std::ranges::is_sorted(reports));
  CHECK(reports[0] == 0);
  CHECK(reports[1] == Approx(0.5 + 0.5 * number_of(ends, PathEnd::Kind::regular) / 8));
  CHECK(reports.back() == 1);
}

TEST_CASE("a path that is lost, or that took another's end, makes the list incomplete") {
  Setting setting(samples::octahedron());
  const std::vector<PathEnd> ends = setting.ends(setting.search(8));
  REQUIRE(setting.report(ends).status == SolveStatus::complete);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    std::vector<PathEnd> killed = ends;
    killed[i].kind = PathEnd::Kind::failed;
    killed[i].cause = "killed";
    CHECK(setting.report(killed).status == SolveStatus::partial);
    CHECK_THAT(setting.report(killed).reason, Catch::Contains("1 path failed: killed"));
    std::vector<PathEnd> jumped = ends;
    jumped[i].x = ends[(i + 1) % ends.size()].x;
    CHECK(setting.report(jumped).status == SolveStatus::partial);
    CHECK_THAT(setting.report(jumped).reason, Catch::Contains("jumped"));
  }
}
