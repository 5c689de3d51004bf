/// The strategy monodromy on scenes that take too long for the contract tests.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/tests/braced_k44.hpp"
#include "harness/tests/strategies/tangent_samples.hpp"
#include "harness/tests/test_folder.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/figures/reflection_classes.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const OptionMap& options = {}, int threads = 1) {
  RunLimits limits;
  limits.threads = threads;
  return run_strategy(find_strategy("monodromy"), options, Scene::unchecked(problem), limits);
}

SolveRun solved(const std::string& instance, const OptionMap& options = {}, int threads = 1) {
  return solved(load_instance(instance).problem, options, threads);
}

/// Those that sphere-tangents finds by eigenvalues.
SolveRun expect_tangents(const ProblemStatement& problem) {
  SolveRun run = solved(problem);
  INFO(run.reason);
  CHECK(run.status == RunStatus::complete);
  CHECK(run.failed_checks.empty());
  CHECK(run.counts.generic == 12);
  CHECK(have_same_lines(run,
                        run_strategy(find_strategy("sphere-tangents"), {}, Scene::unchecked(problem), {})));
  return run;
}

}  // namespace

TEST_CASE("monodromy finds the dodecagon's solutions from nothing, and again from what it kept") {
  // Laman number 6180, half of it up to reflection: Capco et al. 2018. Imbach et al. 2016 have 2 real ones.
  const TestFolder folder;
  const std::string file = (folder / "start.json").string();
  for (const std::string option : {"save_start", "start"}) {
    const SolveRun run = solved("dodecagon", {{option, file}});
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.generic == 3090);
    CHECK(run.counts.complex_up_to_reflection == 3090);
    CHECK(run.counts.real_up_to_reflection == 2);
  }
}

TEST_CASE("where the bound is not met a trace test completes the list") {
  const ProblemStatement open = braced_k44();
  const SolveRun run = solved(open);
  CHECK(run.status == RunStatus::complete);
  const SolveRun without = solved(open, {{"trace", "off"}});
  CHECK(without.status == RunStatus::partial);
  CHECK(without.counts.complex_up_to_reflection == run.counts.complex_up_to_reflection);
}

TEST_CASE("where an exact number or a bound is met no trace test is needed") {
  // Of K3,3 on the sphere Gallet, Grasegger, Schicho 2020 have 16, which a cone over it has in space (g16a); of the pyramid
  // Hoffmann and Yuan 2000 have 24 real ones in their frame, 6 up to reflection.
  const SolveRun run = solved("g16a", {{"trace", "off"}});
  CHECK(run.status == RunStatus::complete);
  CHECK(run.counts.complex_up_to_reflection == 8);
  CHECK(solved("hoffmann-yuan").counts.real_up_to_reflection == 6);
}

/// Some of its hundreds of points have branch points far from the others', or are 1e11 away.
TEST_CASE("a trace test reaches points that are nearly separate from the others") {
  const ProblemStatement problem = load_instance("hoffmann-yuan").problem;
  ProblemStatement other = problem;  // which may have 128, so that nothing but the test says that 72 are all
  std::ranges::find(other.constraints, "a10", &DistanceConstraint::id)->between = {0, 2};
  const SceneAnalysis known_of_other(other);
  const Scene scene(problem);
  SolveMeans means;
  means.seed = GENERATE(as<std::uint64_t>(), 195, 308, 492);
  const StrategyEntry& monodromy = find_strategy("monodromy");
  const SolveReport report = monodromy.make(complete_options(monodromy, {{"reduce", "off"}}))
                                 ->solve(SolveRequest(scene, means, &known_of_other));
  INFO(means.seed << ": " << report.reason);
  CHECK(report.status == SolveStatus::complete);
  CHECK(report.generic == 72U);
  CHECK(report.candidates.size() == 72);
}

TEST_CASE("threads and instruction sets change no number of a solve") {
  const SolveRun one = solved("g160"), two = solved("g160", {{"instructions", "portable"}}, 2);
  CHECK(one.work.iterations == two.work.iterations);
  const auto &ours = one.solutions, &theirs = two.solutions;
  REQUIRE(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    CHECK(ours[i].figure.points == theirs[i].figure.points);
    CHECK(ours[i].figure.imaginary == theirs[i].figure.imaginary);
  }
}

TEST_CASE("what is saved changes the work and not the solutions") {
  const OptionMap without =
      GENERATE(OptionMap{{"precision", "twice"}}, OptionMap{{"mirror_images", "followed"}});
  const std::string strategy = GENERATE("monodromy", "polyhedral");
  CAPTURE(strategy, without);
  const Scene scene(load_instance("k33").problem);
  const SolveRun saving = run_strategy(find_strategy(strategy), {}, scene, {});
  const SolveRun all = run_strategy(find_strategy(strategy), without, scene, {});
  CHECK(all.work.iterations != saving.work.iterations);
  std::vector<Figure> figures;
  for (const SolveRun* run : {&saving, &all}) {
    CHECK(run->status == RunStatus::complete);
    CHECK(run->solutions.size() == 8);  // 16 in a fixed frame, by the recursion for Laman graphs
    for (const AssessedSolution& solution : run->solutions) figures.push_back(solution.figure);
  }
  CHECK(reflection_classes(scene, figures, 1e-9).count() == 8);
}

/// As many paths from mixed cells as the mixed volume, which mirror images divide by 2 in each of two axes.
TEST_CASE("all mirror images are followed where they are not divided out") {
  const Scene scene(load_instance("k33").problem);
  const auto paths = [&](const OptionMap& options) {
    const SolveRun run = run_strategy(find_strategy("polyhedral"), options, scene, {});
    std::map<std::string, std::int64_t> counts;
    for (const Particular& particular : run.particulars) counts[particular.name] = particular.value;
    CHECK(counts.at("mixed_volume") == 512);
    return counts.at("start_paths");
  };
  const std::string coordinates = "coordinates";
  CHECK(paths({{"formulation", coordinates}}) == 128);
  CHECK(paths({{"formulation", coordinates}, {"mirror_images", "followed"}}) == 512);
}

TEST_CASE("lines beside given points are found with the points set free") {
  // Real ones: Durand 1998 and PHCpack's demos; Macdonald, Pach, Theobald 2001.
  for (const auto& [id, real] :
       {std::pair("tangents-durand", 4), {"tangents-12-real", 12}, {"tangents-equal-radii", 12}}) {
    const SolveRun run = expect_tangents(load_instance(id).problem);
    CHECK(run.solutions.size() == 12);
    CHECK(real_ones(run) == real);
  }
  const SolveRun fourfold = expect_tangents(load_instance("tangents-fourfold").problem);
  CHECK(fourfold.solutions.size() == 3);
  CHECK(real_ones(fourfold) == 3);
  for (const AssessedSolution& solution : fourfold.solutions) CHECK(solution.multiplicity == 4);
}

TEST_CASE("given points anywhere have 12 tangents, coplanar and nearly coplanar ones too") {
  Dice dice(19);
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix<double, 3, 4> centers = dice.centers();
    if (i >= 10) centers.row(2) *= i % 2 == 0 ? 0 : std::pow(10, 5 - i);
    expect_tangents(spheres(centers, dice.distances()));
  }
}

TEST_CASE("that lines beside given points are at most 12 saves the trace test") {
  for (const std::string id : {"tangents-durand", "tangents-12-real"}) {
    const Scene scene(load_instance(id).problem);
    const StrategyEntry& entry = find_strategy("monodromy");
    const SolveReport report = entry.make(complete_options(entry, {{"trace", "off"}}))->solve(scene);
    INFO(id << ": " << report.reason);
    CHECK(report.status == SolveStatus::complete);
    CHECK(report.generic == 12u);
  }
}

TEST_CASE("given points on one line are refused") {
  Eigen::Matrix<double, 3, 4> centers = Eigen::Matrix<double, 3, 4>::Zero();
  centers.row(1) << 0, 1, 2.5, 4;
  const SolveRun run = solved(spheres(centers, {1, 0.9, 0.8, 0.95}));
  CHECK(run.status == RunStatus::unsupported);
  CHECK(run.reason.find("not on one line") != std::string::npos);
}
