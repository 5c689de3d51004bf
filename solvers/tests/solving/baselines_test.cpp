/// What stops short of all of S, and what follows the printed text, on random scenes with a sketch.

#include <catch2/catch.hpp>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

SolveReport report_of(std::string_view strategy, const Scene& scene, const OptionMap& given) {
  for (const StrategyEntry& entry : all_strategies())
    if (entry.name == strategy) {
      const SolveRequest request(scene);
      const auto made = entry.make(complete_options(entry, given));
      REQUIRE_FALSE(made->why_unsupported(request));
      return made->solve(request);
    }
  throw std::logic_error("no such strategy");
}

double distance(const Scene& scene, const Candidate& a, const Candidate& b) {
  const Eigen::Matrix3Xd first = scene.in_frame(a.figure, scene.reference()).points;
  return (first - scene.in_frame(b.figure, scene.reference()).points).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("the first solution is the first of those on S") {
  RandomNumbers random(11);
  int compared = 0;
  for (int sample = 0; sample < 24; ++sample) {
    const int dimension = 2 + sample % 2;
    const Scene scene(samples::random_problem(dimension, 5 + random.index(3), random));
    for (const char* strategy : {"full-space", "rcp"})
      for (const char* mode : {"fast", "paper", "certified"}) {
        if (std::string_view(strategy) == "rcp" && std::string_view(mode) == "certified") continue;
        const SolveReport all = report_of(strategy, scene, {{"mode", mode}});
        if (all.status != SolveStatus::complete || all.candidates.empty()) continue;
        CAPTURE(sample, strategy, mode);
        const SolveReport first = report_of(strategy, scene, {{"mode", mode}, {"until", "first"}});
        CHECK(first.status == SolveStatus::complete);
        CHECK(first.claim == Claim::some_real);
        REQUIRE_FALSE(first.candidates.empty());
        CHECK(distance(scene, first.candidates[0], all.candidates[0]) <= 1e-9 * scene.size());
        REQUIRE(first.paths.size() == 1);
        CHECK(first.paths[0].end == PathRecord::End::regular);
        CHECK(first.work.iterations <= all.work.iterations);
        ++compared;
      }
  }
  CHECK(compared > 40);
}

TEST_CASE("Newton's method from the sketch ends at a solution or says that it does not") {
  RandomNumbers random(12);
  for (const char* strategy : {"full-space", "rcp"}) {
    int solved = 0, failed = 0;
    for (int sample = 0; sample < 60; ++sample) {
      const Scene scene(samples::random_problem(2 + sample % 2, 5 + random.index(3), random));
      const SolveReport report = report_of(strategy, scene, {{"mode", "newton"}});
      CAPTURE(strategy, sample, report.reason);
      CHECK(report.claim == Claim::some_real);
      CHECK(report.paths.empty());
      CHECK(report.reason.empty() == (report.status == SolveStatus::complete));
      if (report.status == SolveStatus::complete) {
        ++solved;
        REQUIRE(report.candidates.size() == 1);
        CHECK(relative_residual(scene, report.candidates[0].figure) <= 1e-12);
      } else {
        ++failed;
      }
    }
    CHECK(solved > 0);
    CHECK(failed > 0);
  }
}

TEST_CASE("Newton's method stays where the sketch is a solution") {
  RandomNumbers random(13);
  for (int sample = 0; sample < 12; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 6, random));
    const SolveReport solved = report_of("full-space", scene, {});
    if (solved.candidates.empty()) continue;
    ProblemStatement problem = scene.problem();
    problem.sketch = solved.candidates[0].figure;
    problem.sketch->points *= std::ldexp(1.0, scene.unit_exponent());
    const Scene there(problem);
    for (const char* strategy : {"full-space", "rcp"}) {
      const SolveReport report = report_of(strategy, there, {{"mode", "newton"}});
      CHECK(report.work.newton_iterations <= 4);
      REQUIRE(report.candidates.size() == 1);
      CHECK(distance(there, report.candidates[0], solved.candidates[0]) <= 1e-9 * there.size());
    }
  }
}

TEST_CASE("what the printed text leaves undefined ends a path with the place where it does") {
  RandomNumbers random(14);
  int ended = 0;
  for (int sample = 0; sample < 40 && ended == 0; ++sample) {
    const Scene scene(samples::random_problem(3, 7, random));
    const SolveReport printed = report_of("rcp", scene, {{"mode", "paper"}, {"as", "printed"}});
    const SolveReport restored = report_of(
        "rcp", scene, {{"mode", "paper"}, {"as", "printed"}, {"restoring", "mended"}, {"measure", "mended"}});
    if (printed.reason.find("Algorithm 3") == std::string::npos) continue;
    ++ended;
    CHECK(printed.status == SolveStatus::gave_up);
    CHECK(printed.reason.find("placing p") != std::string::npos);
    CHECK(printed.reason.find("near t = ") != std::string::npos);
    CHECK(restored.reason.find("Algorithm 3") == std::string::npos);
  }
  CHECK(ended == 1);
  const Scene scene(samples::random_problem(3, 7, random));
  CHECK_THROWS_AS(report_of("rcp", scene, {{"as", "printed"}}), OptionError);
}
