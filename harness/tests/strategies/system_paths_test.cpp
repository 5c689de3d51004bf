/// The strategy system-paths against other methods, on octahedra and a pyramid.

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const std::string& strategy, const OptionMap& options = {}) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

std::int64_t particular(const SolveRun& run, const std::string& name) {
  const auto found = std::find_if(run.particulars.begin(), run.particulars.end(),
                                  [&](const Particular& count) { return count.name == name; });
  return found == run.particulars.end() ? -1 : found->value;
}

/// The shipped graph with the distances of random points.
ProblemStatement random_octahedron(std::mt19937_64& random) {
  ProblemStatement problem = load_instance("octahedron").problem;
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Eigen::Matrix3Xd points =
      Eigen::Matrix3Xd::NullaryExpr(3, 6, [&](Eigen::Index, Eigen::Index) { return coordinate(random); });
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    constraint.given = {(points.col(a) - points.col(b)).norm(), ""};
  }
  problem.sketch.reset();
  return problem;
}

void expect_same_counts(const SolveRun& run, const SolveRun& other) {
  CHECK(run.status == RunStatus::complete);
  CHECK(run.failed_checks.empty());
  CHECK(run.counts.complex_up_to_reflection == other.counts.complex_up_to_reflection);
  CHECK(run.counts.real_up_to_reflection == other.counts.real_up_to_reflection);
}

}  // namespace

TEST_CASE("every system of an octahedron has the solutions that eigenvalues give") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 4; ++i) {
    const ProblemStatement problem = random_octahedron(random);
    const SolveRun known = solved(problem, "cayley-menger");
    for (const std::string system : {"quartics", "echelon"}) {
      const SolveRun run = solved(problem, "system-paths", {{"system", system}});
      INFO(i << " " << system << ": " << run.reason);
      expect_same_counts(run, known);
      CHECK(run.counts.paths == 16U);
      CHECK(run.counts.at_infinity == 0U);
      CHECK(particular(run, "total_degree") == 64);
      CHECK(particular(run, "mixed_volume") == 16);
    }
    const SolveRun from_degrees = solved(problem, "system-paths", {{"start", "total-degree"}});
    expect_same_counts(from_degrees, known);
    CHECK(from_degrees.counts.paths == 64U);
    CHECK(from_degrees.counts.at_infinity == 48U);  // Bézout's number less the 16 finite ones
  }
}

TEST_CASE("of 5p1L as many paths end in solutions as polyhedral finds by other equations") {
  const ProblemStatement problem = load_instance("hoffmann-yuan").problem;
  const SolveRun known = solved(problem, "polyhedral");
  const SolveRun run = solved(problem, "system-paths", {{"system", "echelon"}});
  INFO(run.reason);
  expect_same_counts(run, known);
  CHECK(particular(run, "homogeneous_bound") == 512);  // the paper's
  CHECK(particular(run, "total_degree") == 4096);      // 2¹²
  // In the fixed frame the two reflections that keep the line and the apex make four of each.
  CHECK(*run.counts.paths - *run.counts.at_infinity == 4 * known.solutions.size());
}

TEST_CASE("the published systems of tangents have as many paths as their degree") {
  const ProblemStatement problem = load_instance("tangents-durand").problem;
  for (const std::string system : {"quadrics", "cubic"}) {
    const SolveRun run = solved(problem, "sphere-tangents", {{"method", "published"}, {"system", system}});
    CHECK(static_cast<std::int64_t>(run.counts.paths.value_or(0)) == particular(run, "total_degree"));
    CHECK(particular(run, "mixed_volume") <= particular(run, "total_degree"));
    CHECK(particular(run, "mixed_volume") >= 24);  // both directions of the twelve lines
  }
}

TEST_CASE("a system says of which problems it is") {
  CHECK(solved(load_instance("hoffmann-yuan").problem, "system-paths").status == RunStatus::unsupported);
  CHECK(solved(load_instance("octahedron").problem, "system-paths", {{"system", "parametrised"}}).status ==
        RunStatus::unsupported);
  CHECK(solved(load_instance("disulfide").problem, "system-paths").status == RunStatus::unsupported);
}
