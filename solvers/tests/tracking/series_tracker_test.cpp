/// The fast tracker where S is singular or nearly so: it keeps to its arc, or says that it cannot.

#include "solvers/tracking/series_tracker.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

using Places = std::vector<std::array<double, 2>>;

/// In the plane, with a sketch.
ProblemStatement sketched(const samples::Edges& edges, const std::vector<double>& lengths,
                          const Places& places) {
  ProblemStatement problem = samples::problem_of(2, static_cast<int>(places.size()), edges, lengths);
  Figure sketch{Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(places.size())), {}};
  for (std::size_t i = 0; i < places.size(); ++i)
    sketch.points.col(static_cast<Eigen::Index>(i)) << places[i][0], places[i][1], 0;
  problem.sketch = sketch;
  return problem;
}

const Places triangle_places{{0, 0}, {1, 0}, {0.28, 0.96}};

/// Half-way to the target p1–p2 is `missing` shorter than the other two sides together.
ProblemStatement nearly_flat_halfway(double missing) {
  ProblemStatement problem = sketched({{0, 1}, {0, 2}, {1, 2}}, {1, 1, 1.2}, triangle_places);
  problem.interpolation = {0, 4 * (1.2 - missing)};
  return problem;
}

/// The same with another point on p1–p2, on the other side.
ProblemStatement both_nearly_flat_halfway(double missing) {
  Places places = triangle_places;
  places.push_back({0.94, -std::sqrt(1.69 - 0.94 * 0.94)});
  ProblemStatement problem =
      sketched({{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}}, {1, 1, 1.2, 1.3, 0.9}, places);
  problem.interpolation = {0, 4 * (1.2 - missing)};
  return problem;
}

/// At t = 1/2 the triangle is flat, and S goes on in both directions on either side.
ProblemStatement crossing_arcs() {
  return sketched({{0, 2}, {1, 2}, {0, 1}}, {0.7, 0.8, 1}, {{0, 0}, {1, 0}, {0.425, 0.5562148865321747}});
}

SolveReport solved(const ProblemStatement& problem, const std::string& strategy,
                   const OptionMap& options = {}) {
  const Scene scene(problem);
  const auto strategies = all_strategies();
  const StrategyEntry& entry = *std::find_if(strategies.begin(), strategies.end(),
                                             [&](const StrategyEntry& one) { return one.name == strategy; });
  return entry.make(complete_options(entry, options))->solve(scene);
}

/// Twice the signed area of p1, p2 and the point.
double side(const Figure& figure, Eigen::Index point) {
  const Eigen::Vector3d base = figure.points.col(1) - figure.points.col(0);
  return base.cross(figure.points.col(point) - figure.points.col(0)).z();
}

std::vector<double> sides_at_crossings(const SolveReport& report, Eigen::Index point) {
  std::vector<double> sides;
  for (const Candidate& candidate : report.candidates) sides.push_back(side(candidate.figure, point));
  return sides;
}

const std::array<std::string, 2> path_strategies{"full-space", "rcp"};

}  // namespace

TEST_CASE("a path that passes its mirror image stays on its own arc") {
  for (const double missing : {1e-3, 1e-6, 1e-9, 1e-10})
    for (const std::string& strategy : path_strategies) {
      const SolveReport report = solved(nearly_flat_halfway(missing), strategy);
      CAPTURE(-std::log10(missing), strategy, report.reason);
      CHECK(report.status == SolveStatus::complete);
      const std::vector<double> sides = sides_at_crossings(report, 2);
      REQUIRE(sides.size() == 2);
      CHECK(sides[0] > 0);
      CHECK(sides[1] < 0);
    }
}

TEST_CASE("a path that turns back where a triangle gets flat does not go straight on") {
  for (const double missing : {-1e-2, -1e-6, -1e-9, -1e-10})
    for (const std::string& strategy : path_strategies) {
      const SolveReport report = solved(nearly_flat_halfway(missing), strategy);
      CAPTURE(-std::log10(-missing), strategy, report.reason);
      CHECK(report.status == SolveStatus::complete);
      CHECK(report.candidates.empty());
    }
}

TEST_CASE("where arcs come nearer than rounding lets them be followed no path jumps") {
  for (const double missing : {1e-11, 1e-12, 1e-13, 1e-14, 1e-15, -1e-11, -1e-12, -1e-13, -1e-14, -1e-15})
    for (const std::string& strategy : path_strategies) {
      const SolveReport report = solved(nearly_flat_halfway(missing), strategy);
      CAPTURE(-std::log10(std::abs(missing)), strategy, report.reason);
      if (missing < 0) CHECK(report.candidates.empty());
      if (report.status == SolveStatus::complete) continue;
      CHECK(report.status == SolveStatus::gave_up);
      CHECK_THAT(report.reason, Catch::Contains("near t = 0.5") && Catch::Contains("nearly so"));
      CHECK(report.candidates.empty());
    }
}

TEST_CASE("where two arcs of S cross the path strategies give up and say so") {
  for (const std::string& strategy : path_strategies) {
    const SolveReport report = solved(crossing_arcs(), strategy);
    CAPTURE(strategy);
    CHECK(report.status == SolveStatus::gave_up);
    CHECK_THAT(report.reason, Catch::Contains("near t = 0.5") && Catch::Contains("singular"));
  }
}

TEST_CASE("two triangles that get nearly flat at once are followed as one is") {
  // The second one turns over at both ends of S, the first one never.
  for (const double missing : {1e-3, 1e-6, 1e-9})
    for (const std::string& strategy : path_strategies) {
      const SolveReport report = solved(both_nearly_flat_halfway(missing), strategy);
      CAPTURE(-std::log10(missing), strategy, report.reason);
      CHECK(report.status == SolveStatus::complete);
      const std::vector<double> above = sides_at_crossings(report, 2), below = sides_at_crossings(report, 3);
      REQUIRE(above.size() == 2);
      CHECK(above[0] > 0);
      CHECK(below[0] < 0);
      CHECK(above[1] > 0);
      CHECK(below[1] > 0);
    }
}

TEST_CASE("a path does not go on where a length would be negative") {
  // S turns round 1e-4 behind the target, where p1–p3 is still 7e-6 long.
  const ProblemStatement problem =
      sketched({{0, 1}, {1, 2}, {0, 2}, {0, 4}, {1, 4}, {0, 3}, {1, 3}}, {3, 3, 1e-4, 2.3, 2.3, 2, 2.5},
               {{0, 0}, {3, 0}, {0.1, 1}, {1, 2}, {1.5, -1.8}});
  for (const std::string orientation : {"forward", "backward"})
    for (const std::string& strategy : path_strategies) {
      const SolveReport report = solved(problem, strategy, {{"orientation", orientation}});
      CAPTURE(orientation, strategy, report.reason);
      CHECK(report.status == SolveStatus::complete);
      CHECK(report.candidates.size() == 4);
    }
}

TEST_CASE("where a length vanishes on S the path strategies give up and say so") {
  // p3 runs through p1 at t = 1.25.
  ProblemStatement problem =
      sketched({{0, 1}, {1, 2}, {0, 2}}, {3, 3, 0.2}, {{0, 0}, {3, 0}, {1.0 / 6, std::sqrt(35.0) / 6}});
  problem.interpolation = {0, 0};
  for (const std::string& strategy : path_strategies) {
    const SolveReport report = solved(problem, strategy);
    CAPTURE(strategy);
    CHECK(report.status == SolveStatus::gave_up);
    CHECK_THAT(report.reason, Catch::Contains("near t = 1.25") && Catch::Contains("a length vanishes"));
  }
}

TEST_CASE("coefficients beyond the root of the largest number keep no path from closing") {
  for (const std::string& strategy : path_strategies) {
    const SolveReport report = solved(nearly_flat_halfway(1e-8), strategy, {{"order", "40"}});
    CAPTURE(strategy, report.reason);
    CHECK(report.status == SolveStatus::complete);
    CHECK(report.candidates.size() == 2);
  }
}

TEST_CASE("that jumps are not known is said beside the reason why a path failed") {
  const OptionMap options{{"mode", "paper"}, {"jumps", "named"}, {"max_steps", "5"}};
  const SolveReport report = solved(crossing_arcs(), "full-space", options);
  CHECK_THAT(report.reason, Catch::StartsWith("max_steps") && Catch::Contains("; jumps are not known"));
}
