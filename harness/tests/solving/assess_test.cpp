#include "solvers/answers/assess.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "harness/tests/instances/toy_scene.hpp"

using namespace gcs;

namespace {

Scene toy_scene() { return Scene(toy::instance().problem); }

std::vector<std::string> failed_names(const Assessment& assessment) {
  std::vector<std::string> names;
  for (const FailedCheck& check : assessment.failed_checks) names.push_back(check.name);
  return names;
}

using Names = std::vector<std::string>;

std::vector<int> crossing_solutions(const Assessment& assessment) {
  std::vector<int> solutions;
  for (const AssessedCrossing& crossing : assessment.crossings)
    solutions.push_back(crossing.solution.value_or(-1));
  return solutions;
}

}  // namespace

TEST_CASE("mirror images are one class, shown in the file's unit and the frame") {
  const Scene scene = toy_scene();
  const Assessment assessment = assess(scene, toy::good_report(scene));
  CHECK(assessment.failed_checks.empty());
  REQUIRE(assessment.solutions.size() == 2);
  for (const AssessedSolution& solution : assessment.solutions) {
    CHECK(solution.placement().points(0, 1) == 6);
    CHECK(solution.placement().points(1, 2) == 4);
    CHECK(solution.figure.is_real());
    CHECK_FALSE(solution.certified);
    CHECK_FALSE(solution.error_bound);
    CHECK(solution.residual < 1e-15);
    CHECK(solution.condition > 1);
    CHECK(solution.condition < 100);
  }
  CHECK(assessment.solutions[0].placement().points(1, 3) == -8);
  CHECK(assessment.solutions[1].placement().points(1, 3) == 8);
}

TEST_CASE("crossings keep their order and name solutions by their place in the list") {
  const Scene scene = toy_scene();
  const Assessment assessment = assess(scene, toy::good_report(scene));
  CHECK(crossing_solutions(assessment) == std::vector<int>{1, 0, 1, 0});
  CHECK(assessment.crossings[0].direction == 1);
  CHECK(assessment.crossings[1].direction == -1);
}

TEST_CASE("the order of the solutions depends neither on the candidates' order nor on rounding") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  report.claim = Claim::all_real;
  report.paths.clear();
  const Assessment expected = assess(scene, report);
  std::reverse(report.candidates.begin(), report.candidates.end());
  for (Candidate& candidate : report.candidates) candidate.figure.points.array() += 1e-16;
  const Assessment assessment = assess(scene, report);
  REQUIRE(assessment.solutions.size() == 2);
  for (int i : {0, 1})
    CHECK(assessment.solutions[i].figure.points.isApprox(expected.solutions[i].figure.points, 1e-14));
}

TEST_CASE("only what a strategy claims is counted") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  SECTION("on the path") {
    const Counts counts = assess(scene, report).counts;
    CHECK(counts.on_path == 2u);
    CHECK(counts.paths == 1u);
    CHECK(counts.at_infinity == 0u);
    CHECK(counts.failed_paths == 0u);
    CHECK(counts.singular == 0u);
    CHECK_FALSE(counts.real_up_to_reflection);
    CHECK_FALSE(counts.complex_up_to_reflection);
    CHECK_FALSE(counts.generic);
    CHECK_FALSE(counts.certified);
  }
  SECTION("all real ones, without paths") {
    report.claim = Claim::all_real;
    report.paths.clear();
    const Counts counts = assess(scene, report).counts;
    CHECK(counts.real_up_to_reflection == 2u);
    CHECK_FALSE(counts.on_path);
    CHECK_FALSE(counts.paths);
    CHECK_FALSE(counts.failed_paths);
  }
  SECTION("all complex ones, over paths with every end") {
    report.claim = Claim::all_complex;
    report.paths.assign(5, PathRecord{});
    report.paths[0].end = PathRecord::End::regular;
    report.paths[1].end = PathRecord::End::at_infinity;
    report.paths[2].end = PathRecord::End::stopped;
    report.paths[3].end = PathRecord::End::singular;
    const Counts counts = assess(scene, report).counts;
    CHECK(counts.complex_up_to_reflection == 2u);
    CHECK(counts.real_up_to_reflection == 2u);
    CHECK(counts.paths == 5u);
    CHECK(counts.at_infinity == 1u);
    CHECK(counts.failed_paths == 2u);
  }
  SECTION("some") {
    report.claim = Claim::some_real;
    const Counts counts = assess(scene, report).counts;
    CHECK_FALSE(counts.real_up_to_reflection);
    CHECK_FALSE(counts.on_path);
  }
}

TEST_CASE("a path that closes without a crossing is no mistake") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  report.candidates.clear();
  report.paths[0].crossings.clear();
  const Assessment assessment = assess(scene, report);
  CHECK(assessment.failed_checks.empty());
  CHECK(assessment.solutions.empty());
  CHECK(assessment.counts.on_path == 0u);
}

TEST_CASE("a candidate that is no solution fails") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  report.candidates[1] = toy::candidate(scene, {3, 4}, {0, -8 - 1e-11});
  CHECK(failed_names(assess(scene, report)) == Names{"residual"});
}

TEST_CASE("rounding of the coordinates alone does not fail") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  for (Candidate& candidate : report.candidates) candidate.figure.points.array() *= 1 + 4e-16;
  CHECK(assess(scene, report).failed_checks.empty());
}

TEST_CASE("crossings that do not alternate fail") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  SECTION("an odd number on a closed path") {
    report.paths[0].crossings.pop_back();
    report.candidates.pop_back();
    CHECK(failed_names(assess(scene, report)) == Names{"alternation"});
  }
  SECTION("as many up as down, in a wrong order") {
    std::swap(report.paths[0].crossings[1].direction, report.paths[0].crossings[2].direction);
    CHECK(failed_names(assess(scene, report)) == Names{"alternation"});
  }
  SECTION("an odd number on a path that was stopped is right") {
    report.paths[0].crossings.pop_back();
    report.candidates.pop_back();
    report.paths[0].end = PathRecord::End::stopped;
    CHECK(assess(scene, report).failed_checks.empty());
  }
}

TEST_CASE("a path that meets the same point twice has jumped") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  SECTION("another candidate at the same place") { report.candidates[2] = report.candidates[0]; }
  SECTION("the same candidate") { report.paths[0].crossings[2].candidate = 0; }
  CHECK(failed_names(assess(scene, report))[0] == "repetition");
}

TEST_CASE("what is malformed is left out and said") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  SECTION("a crossing of a candidate that is not there") { report.paths[0].crossings[0].candidate = 7; }
  SECTION("a negative candidate") { report.paths[0].crossings[0].candidate = -1; }
  SECTION("a direction that is none") { report.paths[0].crossings[0].direction = 0; }
  SECTION("a coordinate that is not a number") {
    report.candidates[0].figure.points(0, 1) = std::numeric_limits<double>::quiet_NaN();
  }
  SECTION("a missing point") { report.candidates[0].figure.points.conservativeResize(3, 3); }
  SECTION("a line that the scene does not have") { report.candidates[0].figure.lines.resize(1); }
  SECTION("no multiplicity") { report.candidates[0].multiplicity = 0; }
  const Assessment assessment = assess(scene, report);
  REQUIRE_FALSE(assessment.failed_checks.empty());
  CHECK(assessment.failed_checks[0].name == "malformed");
  CHECK(assessment.crossings.size() == 3);
  CHECK(assessment.solutions.size() == 2);
}

TEST_CASE("a candidate on the path that no crossing names fails") {
  const Scene scene = toy_scene();
  SolveReport report = toy::good_report(scene);
  report.paths[0].crossings.resize(2);
  CHECK(failed_names(assess(scene, report)) == Names{"off path", "off path"});
}

TEST_CASE("a singular solution is counted as such, by its multiplicity or by its Jacobian") {
  SECTION("multiplicity") {
    const Scene scene = toy_scene();
    SolveReport report = toy::good_report(scene);
    report.candidates[2].multiplicity = 2;  // the mirror image of candidate 0
    const Assessment assessment = assess(scene, report);
    CHECK(assessment.counts.singular == 1u);
    CHECK(assessment.solutions[1].multiplicity == 2);
  }
  SECTION("Jacobian") {
    const Scene scene(toy::instance("2", "4").problem);
    SolveReport report;
    report.claim = Claim::all_real;
    report.candidates = {toy::candidate(scene, {3, 4}, {2, 0})};
    const Assessment assessment = assess(scene, report);
    CHECK(assessment.counts.singular == 1u);
    CHECK(assessment.counts.real_up_to_reflection == 1u);
  }
}

TEST_CASE("ill-conditioned candidates are merged as coarsely as their accuracy asks for") {
  const Scene scene(toy::instance("2", "4").problem);
  SolveReport report;
  report.claim = Claim::all_real;
  SECTION("close together: one double solution found twice") {
    report.candidates = {toy::candidate(scene, {3, 4}, {2, 1e-8}), toy::candidate(scene, {3, 4}, {2, -1e-8})};
    CHECK(assess(scene, report).solutions.size() == 1);
  }
  SECTION("too far apart for that") {
    report.candidates = {toy::candidate(scene, {3, 4}, {2, 1e-3}), toy::candidate(scene, {3, 4}, {2, -1e-3})};
    CHECK(assess(scene, report).solutions.size() == 2);
  }
}

TEST_CASE("well-conditioned neighbours stay apart whatever else there is") {
  // p4 once at a double solution, once 1e-6 beside a regular one: the latter are two candidates of no common
  // class.
  const Scene scene = toy_scene();
  SolveReport report;
  report.claim = Claim::all_real;
  report.candidates = {toy::candidate(scene, {3, 4}, {0, 8}), toy::candidate(scene, {3, 4}, {1e-6, 8}),
                       toy::candidate(scene, {3, 4}, {2, 1e-9})};
  CHECK(assess(scene, report).solutions.size() == 3);
}

TEST_CASE("keeping the first solutions keeps the counts in line with the list") {
  const Scene scene = toy_scene();
  Assessment assessment = assess(scene, toy::good_report(scene));
  SECTION("fewer than there are") {
    keep_first(assessment, 1);
    CHECK(assessment.solutions.size() == 1);
    CHECK(assessment.counts.on_path == 1u);
    CHECK_FALSE(assessment.counts.real_up_to_reflection);
    CHECK(crossing_solutions(assessment) == std::vector<int>{-1, 0, -1, 0});
  }
  SECTION("more than there are") {
    keep_first(assessment, 9);
    CHECK(assessment.solutions.size() == 2);
    CHECK(assessment.counts.on_path == 2u);
  }
}
