/// The strategy theta-scan against what Hoffmann and Yuan 2000, section 4.4, print for their example.

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/figures/reflection_classes.hpp"

using namespace gcs;

namespace {

ProblemStatement example() { return load_instance("hoffmann-yuan").problem; }

SolveRun scanned(const ProblemStatement& problem, OptionMap options) {
  options["method"] = "published";
  return run_strategy(find_strategy("theta-scan"), options, Scene::unchecked(problem), {});
}

std::int64_t particular(const SolveRun& run, const std::string& name) {
  const auto found = std::find_if(run.particulars.begin(), run.particulars.end(),
                                  [&](const Particular& p) { return p.name == name; });
  return found == run.particulars.end() ? -1 : found->value;
}

/// The example's graph with the lengths of a placement whose line is the x-axis.
ProblemStatement with_lengths_of(const Figure& placement) {
  ProblemStatement problem = example();
  for (DistanceConstraint& c : problem.constraints) {
    const auto [a, b] = c.between;
    const Eigen::Vector3d p = placement.points.col(a);
    c.given = {problem.is_point(b) ? (p - placement.points.col(b)).norm() : p.tail<2>().norm(), ""};
  }
  return problem;
}

}  // namespace

TEST_CASE("steps of 1° give the paper's coarse and refined solutions") {
  const SolveRun narrow = scanned(example(), {{"delta", "0.1"}});
  CHECK(particular(narrow, "coarse_solutions") == 108);
  CHECK(particular(narrow, "refined_solutions") == 20);
  const SolveRun wide = scanned(example(), {{"delta", "0.2"}});
  CHECK(particular(wide, "coarse_solutions") == 224);
  CHECK(particular(wide, "refined_solutions") == 24);
  CHECK(wide.solutions.size() == 6);
  CHECK(wide.failed_checks.empty());
}

// "When δ > 0.2 we have more than 224 coarse solutions but the refined real solution number is still 24."
TEST_CASE("wider bands and finer steps refine to the same 24 solutions") {
  for (const std::string delta : {"0.3", "0.5", "1"}) {
    const SolveRun run = scanned(example(), {{"delta", delta}});
    CHECK(particular(run, "coarse_solutions") > 224);
    CHECK(particular(run, "refined_solutions") == 24);
  }
  for (const std::string delta : {"0.2", "1"})
    CHECK(particular(scanned(example(), {{"dtheta", "0.1"}, {"delta", delta}}), "refined_solutions") == 24);
}

TEST_CASE("another first angle gives other coarse solutions and no other refined ones") {
  const SolveRun run = scanned(example(), {{"start", "0.5"}, {"dtheta", "0.25"}});
  CHECK(particular(run, "refined_solutions") == 24);
  CHECK(run.work.evaluations == 1440);
}

TEST_CASE("whatever is coarse is refined, or counted as without a solution") {
  const SolveRun run = scanned(example(), {{"delta", "9"}});
  const std::int64_t coarse = particular(run, "coarse_solutions");
  CHECK(coarse > 1000);
  CHECK(particular(run, "coarse_without_solution") >= 0);
  CHECK(particular(run, "coarse_without_solution") <= coarse - particular(run, "refined_solutions"));
  CHECK(run.status == RunStatus::complete);
}

TEST_CASE("whichever point of the base is named first, the solutions are the same") {
  const ProblemStatement problem = example();
  const SolveRun first = scanned(problem, {{"dtheta", "0.25"}, {"delta", "0.5"}});
  REQUIRE(first.solutions.size() == 6);
  for (int shift = 1; shift < 4; ++shift) {
    const auto renamed = [shift](int entity) { return entity < 4 ? (entity + shift) % 4 : entity; };
    ProblemStatement turned = problem;
    for (DistanceConstraint& c : turned.constraints)
      c.between = {renamed(c.between[0]), renamed(c.between[1])};
    SolveRun run = scanned(turned, {{"dtheta", "0.25"}, {"delta", "0.5"}});
    REQUIRE(run.solutions.size() == 6);
    std::vector<Figure> figures;
    for (const AssessedSolution& solution : first.solutions) figures.push_back(solution.figure);
    for (const AssessedSolution& solution : run.solutions) {
      Figure figure = solution.figure;
      for (int p = 0; p < 4; ++p) figure.points.col(p) = solution.figure.points.col(renamed(p));
      figures.push_back(figure);
    }
    CHECK(reflection_classes(Scene::unchecked(problem), figures, 1e-9).count() == 6);
  }
}

TEST_CASE("the solutions are the same in a frame of points") {
  ProblemStatement problem = example();
  const SolveRun in_line_frame = scanned(problem, {});
  problem.reference = Reference{0, 1, 4};
  const SolveRun in_point_frame = scanned(problem, {});
  CHECK(particular(in_point_frame, "refined_solutions") == 24);
  CHECK(in_point_frame.failed_checks.empty());
  REQUIRE(in_point_frame.solutions.size() == 6);
  for (const AssessedSolution& solution : in_point_frame.solutions) {
    const auto is_same = [&](const AssessedSolution& other) {
      const std::vector<Figure> pair{solution.figure, other.figure};
      return reflection_classes(Scene::unchecked(problem), pair, 1e-9).count() == 1;
    };
    const auto& others = in_line_frame.solutions;
    CHECK(std::count_if(others.begin(), others.end(), is_same) == 1);
  }
}

TEST_CASE("a fine scan finds the placement that lengths were taken from") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (int i = 0; i < 20; ++i) {
    Figure placement;
    placement.points =
        Eigen::Matrix3Xd::NullaryExpr(3, 5, [&](Eigen::Index, Eigen::Index) { return coordinate(random); });
    placement.lines = {LinePosition{}};
    const ProblemStatement problem = with_lengths_of(placement);
    const SolveRun run = scanned(problem, {{"dtheta", "0.1"}, {"delta", "0.2"}});
    INFO("placement " << i);
    CHECK(run.status == RunStatus::complete);
    CHECK(run.failed_checks.empty());
    std::vector<Figure> figures;
    for (const AssessedSolution& solution : run.solutions) figures.push_back(solution.placement());
    const int found = reflection_classes(Scene::unchecked(problem), figures, 1e-9).count();
    figures.push_back(placement);
    CHECK(reflection_classes(Scene::unchecked(problem), figures, 1e-8).count() == found);
  }
}

TEST_CASE("theta-scan says what it is not for") {
  CHECK(scanned(load_instance("octahedron").problem, {}).status == RunStatus::unsupported);
  CHECK(scanned(load_instance("tangents-durand").problem, {}).status == RunStatus::unsupported);
  ProblemStatement touching = example();
  touching.constraints[1].given = {0, "0"};
  CHECK(scanned(touching, {}).status == RunStatus::unsupported);
}
