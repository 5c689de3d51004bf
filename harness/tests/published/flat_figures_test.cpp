/// Figures that are their own mirror images, at which Jacobians lose rank: real whatever the rounding of
/// paths.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <random>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"

using namespace gcs;

namespace {

using Place = std::array<int, 2>;

/// All distances between points of the plane, in a space of `dimension`.
Scene all_distances(const std::vector<Place>& places, int dimension) {
  std::string points, constraints;
  for (std::size_t i = 0; i < places.size(); ++i) {
    points += fmt::format("{}\"p{}\"", i == 0 ? "" : ", ", i);
    for (std::size_t j = 0; j < i; ++j) {
      const int x = places[i][0] - places[j][0], y = places[i][1] - places[j][1];
      constraints += fmt::format(R"({}{{"type": "distance", "between": ["p{}", "p{}"], "squared": {}}})",
                                 constraints.empty() ? "" : ", ", j, i, x * x + y * y);
    }
  }
  const std::string text = fmt::format(
      R"({{"format": "gcsbench-instance/1", "id": "flat", "dimension": {}, "points": [{}], "constraints": [{}]}})",
      dimension, points, constraints);
  return Scene(parse_instance(text, "flat.json").problem);
}

/// No three on a line.
std::vector<Place> four_places(std::mt19937_64& random) {
  std::uniform_int_distribution<int> coordinate(-9, 9);
  while (true) {
    std::vector<Place> places(4);
    for (Place& place : places) place = {coordinate(random), coordinate(random)};
    bool is_general = true;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      const Place &a = places[(left_out + 1) % 4], &b = places[(left_out + 2) % 4],
                  &c = places[(left_out + 3) % 4];
      is_general = is_general && (b[0] - a[0]) * (c[1] - a[1]) != (b[1] - a[1]) * (c[0] - a[0]);
    }
    if (is_general) return places;
  }
}

/// One class, which is real; what certificates say of it is that it is a multiple one.
void check_one_real_class(const Scene& scene) {
  for (const std::string strategy : {"monodromy", "polyhedral"})
    for (const std::uint64_t seed : {1, 2, 3}) {
      RunLimits limits;
      limits.seed = seed;
      limits.certify = true;
      const SolveRun run = run_strategy(find_strategy(strategy), {}, scene, limits);
      INFO(strategy << ", seed " << seed << ": " << run.reason);
      CHECK(run.status == RunStatus::complete);
      CHECK(run.counts.complex_up_to_reflection == Natural(1));
      CHECK(run.counts.real_up_to_reflection == Natural(1));
      for (const FailedCheck& check : run.failed_checks) CHECK(check.name == "singular");
    }
}

}  // namespace

TEST_CASE("a flat triangle is real") {
  for (const int dimension : {2, 3}) {
    check_one_real_class(all_distances({{0, 0}, {3, 0}, {7, 0}}, dimension));
    check_one_real_class(all_distances({{0, 0}, {1, 0}, {3, 0}}, dimension));
  }
}

TEST_CASE("flat tetrahedra are real") {
  std::mt19937_64 random(5);
  check_one_real_class(all_distances({{8, 4}, {2, 3}, {9, -9}, {5, -8}}, 3));
  for (int trial = 0; trial < 20; ++trial) check_one_real_class(all_distances(four_places(random), 3));
}

TEST_CASE("points on a line in space are solved: a multiple solution, and no other next to it") {
  const std::string text = R"({"format": "gcsbench-instance/1", "id": "met", "dimension": 3,
    "points": ["p0", "p1", "p2", "p3"], "lines": ["L"], "constraints": [
    {"type": "distance", "between": ["p0", "p1"], "squared": 41},
    {"type": "distance", "between": ["p0", "p2"], "squared": 11},
    {"type": "distance", "between": ["p0", "p3"], "squared": 123},
    {"type": "distance", "between": ["p1", "p2"], "squared": 34},
    {"type": "distance", "between": ["p1", "p3"], "squared": 178},
    {"type": "distance", "between": ["p2", "p3"], "squared": 164},
    {"type": "distance", "between": ["p0", "L"], "squared": 25},
    {"type": "distance", "between": ["p1", "L"], "squared": 0},
    {"type": "distance", "between": ["p2", "L"], "squared": 25},
    {"type": "distance", "between": ["p3", "L"], "squared": 169}]})";
  const Scene scene(parse_instance(text, "met.json").problem);
  const SolveRun run = run_strategy(find_strategy("monodromy"), {}, scene, {});
  INFO(run.reason);
  CHECK(run.status == RunStatus::complete);
  bool is_found = false;  // (0, 0, 5), (4, 0, 0), (1, 3, 4), (7, −5, 12), and the x-axis
  for (const AssessedSolution& solution : run.solutions) {
    is_found = is_found || (solution.figure.is_real() && solution.multiplicity == 2);
    if (solution.multiplicity > 1) CHECK(solution.condition >= 1e12);
  }
  CHECK(is_found);
}
