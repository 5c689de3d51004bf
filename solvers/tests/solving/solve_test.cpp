/// The library as its callers see it: a problem stated in C++, solved and assessed. Expected values come from the law of
/// cosines and from the degrees of freedom.

#include <catch2/catch.hpp>
#include <cmath>
#include <gcsbench/gcsbench.hpp>
#include <set>

using namespace gcs;

namespace {

Problem triangle() {
  Problem problem(2);
  problem.points("a", "b", "c").distance("a", "b", "3.1").distance("b", "c", 4).distance("c", "a", 5);
  return problem;
}

/// K_{3,3} with these lengths in the plane: several real and complex classes.
Problem two_triangles_across() {
  Problem problem(2);
  problem.points("a", "b", "c", "d", "e", "f");
  int length = 0;
  for (const char* left : {"a", "b", "c"})
    for (const char* right : {"d", "e", "f"})
      problem.distance(left, right, std::to_string(20 + 7 * length++ % 11));
  return problem;
}

std::string refusal(const Problem& problem) {
  try {
    problem.instance();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a triangle that is stated in C++ is placed by the law of cosines") {
  const Answer answer = solve(triangle(), Monodromy{.seed = 1, .certify = true});
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.reason.empty());
  REQUIRE(answer.solutions.size() == 1);
  const AssessedSolution& solution = answer.solutions[0];
  CHECK(solution.certified);
  const double x = (3.1 * 3.1 + 25 - 16) / (2 * 3.1);
  REQUIRE(solution.point("c").size() == 2);
  CHECK(solution.point("a").norm() < 1e-15);
  CHECK(solution.point("b")[0] == Approx(3.1).epsilon(1e-15));
  CHECK(solution.point("c")[0] == Approx(x).epsilon(1e-14));
  CHECK(solution.point("c")[1] == Approx(std::sqrt(25 - x * x)).epsilon(1e-14));
  CHECK(solution.complex_point("c").real() == solution.point("c"));
  CHECK_THROWS_AS(solution.point("d"), std::out_of_range);
  CHECK_THROWS_AS(solution.line("a"), std::out_of_range);
}

TEST_CASE("a complex solution has complex points alone") {
  Problem problem(2);
  problem.points("a", "b", "c", "d", "e").distance("a", "b", 4).distance("b", "c", 5).distance("c", "a", 6);
  problem.distance("d", "a", 4).distance("d", "b", 5).distance("e", "d", 2).distance("e", "c", 3);
  const Answer answer = solve(problem, "monodromy");
  CHECK(answer.status == RunStatus::complete);
  int complex = 0;
  for (const AssessedSolution& solution : answer.solutions) {
    if (solution.is_real()) continue;
    ++complex;
    CHECK_THROWS_AS(solution.point("e"), std::domain_error);
    const Eigen::VectorXcd along = solution.complex_point("e") - solution.complex_point("c");
    CHECK(std::abs(along.array().square().sum() - 9.0) < 1e-12);
  }
  CHECK(complex > 0);
}

TEST_CASE("texts are exact numbers and doubles are what they are") {
  Problem problem(2);
  problem.points("a", "b", "c")
      .distance("a", "b", "0.1")
      .distance("b", "c", 0.1)
      .squared_distance("c", "a", "2e-2");
  const ProblemStatement statement = problem.instance().problem;
  CHECK(statement.constraints[0].given.text == "0.1");
  // 0.1 in binary, written out: IEEE 754.
  CHECK(statement.constraints[1].given.text == "0.1000000000000000055511151231257827021181583404541015625");
  CHECK(statement.constraints[0].given.value == statement.constraints[1].given.value);
  CHECK(statement.constraints[2].is_squared);
}

TEST_CASE("positions and a sketch reach the strategies") {
  Problem problem(2);
  problem.points("a", "b", "c").fix("a", {0, 0}).fix("b", {"3.1", 0});
  problem.distance("b", "c", 4).distance("c", "a", 5);
  const Answer fixed = solve(problem, "plan-scan");
  CHECK(fixed.counts.real_up_to_reflection == Natural(2));

  const Answer without = solve(triangle(), "full-space");
  CHECK(without.status == RunStatus::unsupported);
  CHECK_THAT(without.reason, Catch::Contains("sketch"));
  const Answer path =
      solve(triangle().sketch("a", {0, 0}).sketch("b", {3, 0}).sketch("c", {3, 4}), "full-space");
  CHECK(path.status == RunStatus::complete);
  CHECK(path.counts.on_path == 1u);
}

TEST_CASE("lines are stated like points, and placed") {
  Problem problem(3);
  problem.points("p", "q", "r", "s").lines("l");
  problem.fix("p", {0, 0, 0}).fix("q", {2, 0, 0}).fix("r", {0, 2, 0}).fix("s", {0, 0, 2});
  for (const char* point : {"p", "q", "r", "s"}) problem.distance(point, "l", "0.9");
  const Answer answer = solve(problem, "sphere-tangents");
  CHECK(answer.status == RunStatus::complete);
  REQUIRE_FALSE(answer.solutions.empty());
  for (const AssessedSolution& solution : answer.solutions) {
    if (!solution.is_real()) continue;
    const LinePosition line = solution.line("l");
    CHECK((line.point - line.point.dot(line.direction) * line.direction).norm() ==
          Approx(0.9).epsilon(1e-12));
  }
}

TEST_CASE("what is wrong with a problem is said as of a file, with its place") {
  CHECK(refusal(triangle()).empty());
  CHECK_THAT(refusal(Problem(4).points("a")),
             Catch::Contains("problem: /dimension: the dimension is 4; give 2 or 3"));
  CHECK_THAT(refusal(triangle().points("a")), Catch::Contains("/points/3: the name 'a' is given twice"));
  CHECK_THAT(refusal(triangle().distance("a", "d", 1)), Catch::Contains("/constraints/3/between/1"));
  CHECK_THAT(refusal(triangle().distance("a", "b", 1)), Catch::Contains("over-constrained"));
  CHECK_THAT(refusal(triangle().points("d").distance("a", "d", "1,5")),
             Catch::Contains("/constraints/3/length"));
  CHECK_THAT(refusal(triangle().points("d").distance("a", "d", -1)), Catch::Contains("is > 0"));
  CHECK_THAT(refusal(triangle().points("d").distance("a", "d", std::nan(""))), Catch::Contains("/length"));
  CHECK_THAT(refusal(triangle().points("d")), Catch::Contains("under-constrained"));
  // The triangle inequality.
  Problem flat(2);
  flat.points("a", "b", "c").distance("a", "b", 1).distance("b", "c", 1).distance("c", "a", 3);
  CHECK_THAT(refusal(flat), Catch::Contains("/constraints/2"));
  CHECK_THROWS_AS(solve(flat, "monodromy"), InputError);
}

TEST_CASE("a scene is made of well-posed problems alone, whoever states them") {
  ProblemStatement statement = triangle().instance().problem;
  CHECK(Scene(statement).constraint_count() == 3);
  statement.constraints.pop_back();
  Problem loose(2);
  loose.points("a", "b", "c").distance("a", "b", "3.1").distance("b", "c", 4);
  CHECK_THROWS_WITH(Scene(statement), Catch::Equals(refusal(loose)));
  statement = triangle().instance().problem;
  statement.constraints[1].given.value = 9;
  CHECK_THROWS_WITH(Scene(statement),
                    Catch::StartsWith("problem: /constraints/1: no figure has these lengths"));
}

TEST_CASE("an instance is read from a text") {
  const std::string text = R"({"format": "gcsbench-instance/1", "id": "triangle", "dimension": 2,
                               "points": ["a", "b", "c"],
                               "constraints": [{"type": "distance", "between": ["a", "b"], "length": 3.1},
                                               {"type": "distance", "between": ["b", "c"], "length": 4},
                                               {"type": "distance", "between": ["c", "a"], "length": 5}]})";
  CHECK(solve(parse_instance(text), "monodromy").counts.complex_up_to_reflection == Natural(1));
  CHECK_THROWS_WITH(parse_instance("{}"), Catch::StartsWith("instance: "));
}

TEST_CASE("random starts end when few solutions are expected to be unseen, or when all are made") {
  const auto starts = [](double unseen) {
    const Answer answer = solve(triangle(), NewtonMultistart{.starts = 200, .unseen = unseen});
    REQUIRE(answer.particulars.at(0).name == "starts");
    return answer.particulars[0].value;
  };
  CHECK(starts(0) == 200);
  CHECK(starts(0.5) < 200);
}

TEST_CASE("strategies and options are named, and misspelt ones refused with what was meant") {
  CHECK_THROWS_WITH(solve(triangle(), "monodrome"), Catch::Contains("did you mean 'monodromy'?"));
  CHECK_THROWS_AS(solve(triangle(), "monodromy", {{"loops", "3"}}), OptionError);
  CHECK_THROWS_AS(solve(triangle(), "monodromy", {{"arcs", "1"}}), OptionError);
  CHECK_THROWS_AS(solve(triangle(), "monodromy", {{"save_start", "start.json"}}), OptionError);
  CHECK_THROWS_AS(solve(triangle(), Monodromy{.threads = 0, .certify = true}), OptionError);
  CHECK_THROWS_AS(solve(triangle(), "monodromy", {}, {.digits = -1}), OptionError);
  const Answer answer = solve(triangle(), "monodromy", {{"order", "8"}}, {.seed = 7, .threads = 2});
  CHECK(answer.options.at("order") == "8");
  CHECK(answer.options.at("arcs") == "12");
  CHECK(answer.seed == 7);
  CHECK(answer.strategy == "monodromy");
}

TEST_CASE("typed options ask for what texts ask for") {
  const Problem problem = two_triangles_across();
  const Answer typed =
      solve(problem, Monodromy{.seed = 5, .arcs = 9, .tracking = {.order = 14}}, {.only_real = true});
  const Answer named =
      solve(problem, "monodromy", {{"arcs", "9"}, {"order", "14"}}, {.seed = 5, .only_real = true});
  CHECK(typed.options == named.options);
  CHECK(typed.seed == named.seed);
  REQUIRE(typed.solutions.size() == named.solutions.size());
  for (std::size_t i = 0; i < typed.solutions.size(); ++i)
    CHECK(typed.solutions[i].figure.points == named.solutions[i].figure.points);
  CHECK_THROWS_AS(solve(problem, Monodromy{.arcs = 1}), OptionError);
}

TEST_CASE("progress and stages are heard, in order") {
  std::set<std::string> heard;
  std::vector<SolveStage> stages;
  SolveSurroundings surroundings;
  surroundings.progress = [&](std::string_view stage, double) { heard.emplace(stage); };
  surroundings.entered = [&](SolveStage stage) { stages.push_back(stage); };
  solve(two_triangles_across(), "monodromy", {}, {.certify = true, .digits = 20}, surroundings);
  CHECK(heard.contains("solutions at random lengths"));
  CHECK(stages == std::vector{SolveStage::preparing, SolveStage::solving, SolveStage::assessing,
                              SolveStage::proving, SolveStage::listing, SolveStage::refining,
                              SolveStage::done});
}

TEST_CASE("a solve that is stopped says so, and by whom when that is told") {
  std::stop_source stop;
  stop.request_stop();
  const Answer stopped = solve(two_triangles_across(), "monodromy", {}, {}, {.stop = stop.get_token()});
  CHECK(stopped.status == RunStatus::stopped);
  CHECK(stopped.reason == "stopped on request");
  const auto at_noon = [](SolveStage) { return StopCause{RunStatus::timed_out, "it is noon"}; };
  const Answer late =
      solve(two_triangles_across(), "monodromy", {}, {}, {.stop = stop.get_token(), .why_stopped = at_noon});
  CHECK(late.status == RunStatus::timed_out);
  CHECK(late.reason == "it is noon");

  // While solutions are proven: what was found is kept.
  std::stop_source in_proofs;
  SolveSurroundings surroundings{.stop_proofs = in_proofs.get_token()};
  surroundings.entered = [&](SolveStage stage) {
    if (stage == SolveStage::proving) in_proofs.request_stop();
  };
  const Answer unproven = solve(two_triangles_across(), "monodromy", {}, {.certify = true}, surroundings);
  CHECK(unproven.status == RunStatus::stopped);
  CHECK(unproven.reason == "stopped on request while solutions were proven");
  CHECK(unproven.counts.certified == 0u);
  CHECK(unproven.solutions.size() == solve(two_triangles_across(), "monodromy").solutions.size());
}

TEST_CASE("a solve is stopped while ends at which paths met are settled") {
  // Legs of one length between two figures that are one in the other's place: solutions meet, and translations move them.
  Problem platform(3);
  const auto figure = [&](const std::string& name, const std::string& point) {
    platform.body(name, {{point + "0", {0, 0, 0}},
                         {point + "1", {1.2, 0.3, -0.4}},
                         {point + "2", {-0.7, 1.1, 0.2}},
                         {point + "3", {0.4, -0.9, 1.3}},
                         {point + "4", {1.5, 1.4, 0.6}},
                         {point + "5", {-1.1, 0.2, 1.2}}});
  };
  figure("base", "a");
  figure("platform", "b");
  for (int i = 0; i < 6; ++i) platform.distance("a" + std::to_string(i), "b" + std::to_string(i), 2);
  std::stop_source stop;
  SolveSurroundings surroundings{.stop = stop.get_token()};
  surroundings.progress = [&](std::string_view stage, double share) {
    if (stage == "paths to the given values" && share == 1) stop.request_stop();
  };
  const Answer answer = solve(platform, "monodromy", {}, {}, surroundings);
  CHECK(stop.stop_requested());
  CHECK(answer.status == RunStatus::stopped);
}

TEST_CASE("an instance is read from a file and solved") {
  const Instance instance = read_instance(GCSBENCH_SOURCE_DIR "/instances/k33.json");
  const Answer answer = solve(instance, "monodromy");
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.counts.generic == Natural(8));  // the Laman number of K33 is 16 with mirror images
  CHECK_THROWS_AS(read_instance("/no/such/file.json"), InputError);
}

namespace {

/// The distances of a figure of six points in space, all but three that share no point.
Problem octahedron_of_points() {
  const double points[6][3] = {{0, 0, 0},       {1.5, 0.2, 0.1},  {0.4, 1.3, -0.2},
                               {1.1, 0.6, 1.4}, {-0.3, 0.9, 0.8}, {0.2, -0.8, 1.2}};
  const char* names[6] = {"a", "b", "c", "d", "e", "f"};
  Problem problem(3);
  problem.points("a", "b", "c", "d", "e", "f");
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j) {
      if (j - i == 3) continue;
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) square += std::pow(points[i][axis] - points[j][axis], 2);
      problem.distance(names[i], names[j], std::sqrt(square));
    }
  return problem;
}

}  // namespace

TEST_CASE("strategies that know distances alone solve scenes with an orientation, and their mirror images") {
  for (const int sign : {1, -1}) {
    Problem space = octahedron_of_points(), plane = two_triangles_across();
    space.orientation({"a", "b", "c", "d"}, sign);
    plane.orientation({"a", "b", "d"}, sign);
    const Answer eliminated = solve(space, CayleyMenger{.certify = true}),
                 followed = solve(space, Monodromy{.certify = true});
    CHECK(eliminated.status == RunStatus::complete);
    CHECK(eliminated.failed_checks.empty());
    CHECK(eliminated.counts.complex_up_to_reflection == followed.counts.complex_up_to_reflection);
    CHECK(eliminated.counts.certified == eliminated.solutions.size());
    const std::optional<std::uint64_t> others = followed.counts.not_as_stated;
    REQUIRE(others.value_or(0) > 0);  // each the mirror image of one that is as stated
    CHECK(eliminated.counts.real_up_to_reflection == Natural(*others));
    CHECK(eliminated.counts.not_as_stated == others);
    const Answer boxed = solve(plane, BoxSubdivision{.certify = true}),
                 all = solve(plane, Monodromy{.certify = true});
    CHECK(boxed.status == RunStatus::complete);
    CHECK(boxed.failed_checks.empty());
    CHECK(boxed.counts.real_up_to_reflection == all.counts.real_up_to_reflection);
    CHECK(boxed.counts.not_as_stated == all.counts.not_as_stated);
    CHECK(boxed.counts.certified == boxed.solutions.size());
  }
}

TEST_CASE("an orientation that nothing else leaves a choice of is no reason to do what a strategy cannot") {
  Problem problem = triangle();
  problem.orientation({"a", "b", "c"}, 1);
  const Answer answer = solve(problem, CayleyMenger{});
  CHECK(answer.status == RunStatus::unsupported);
  CHECK_THAT(answer.reason, Catch::Contains("octahedra"));
}
