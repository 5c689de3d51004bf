/// Scenes with symmetries and near misses that hide solutions from those who count them by sums, distances or
/// what was placed before.

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"

using namespace gcs;

namespace {

struct Length {
  const char *from, *to;
  const char* squared;
};

std::string constraints_text(const std::vector<Length>& lengths) {
  std::string text;
  for (const auto& [from, to, squared] : lengths)
    text += (text.empty() ? "" : ",\n ") + std::string(R"({"type": "distance", "between": [")") + from +
            "\", \"" + to + "\"], \"squared\": " + squared + "}";
  return "\"constraints\": [" + text + "]}";
}

ProblemStatement problem_of(const std::string& head, const std::vector<Length>& lengths) {
  const std::string text =
      R"({"format": "gcsbench-instance/1", "id": "x", )" + head + ", " + constraints_text(lengths);
  return parse_instance(text, "x").problem;
}

SolveRun solved(const ProblemStatement& problem, const std::string& strategy, std::uint64_t seed = 1,
                const OptionMap& options = {}) {
  RunLimits limits;
  limits.seed = seed;
  return run_strategy(find_strategy(strategy), options, Scene(problem), limits);
}

/// Complete and so many classes, or not complete.
void check_never_wrong(const SolveRun& run, std::uint64_t real, std::uint64_t complex) {
  INFO(run.strategy << ", " << run.reason);
  if (run.status != RunStatus::complete) return;
  CHECK(run.counts.real_up_to_reflection == real);
  CHECK(run.counts.complex_up_to_reflection == complex);
}

}  // namespace

// Two points hang on three fixed ones in a coordinate plane: each on either side of it, whatever the other
// does.
TEST_CASE("the trace test sees images that are not divided out") {
  const ProblemStatement space = problem_of(
      R"("dimension": 3, "points": ["p1", "p2", "p3", "p4", "p5"],
      "fixed": {"p1": [0, 0, 0], "p2": [3, 0, 0], "p3": [1, 3, 0]})",
      {{"p4", "p1", "4"},
       {"p4", "p2", "4"},
       {"p4", "p3", "6.25"},
       {"p5", "p1", "9"},
       {"p5", "p2", "4"},
       {"p5", "p3", "9"}});
  const ProblemStatement plane = problem_of(
      R"("dimension": 2, "points": ["p1", "p2", "p3", "p4"], "fixed": {"p1": [0, 0], "p2": [3, 0]})",
      {{"p3", "p1", "4"}, {"p3", "p2", "4"}, {"p4", "p1", "9"}, {"p4", "p2", "4"}});
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    CAPTURE(seed);
    const SolveRun run = solved(space, "monodromy", seed);
    CHECK(run.counts.real_up_to_reflection.value_or(4) <= 4u);
    if (run.status != RunStatus::complete) continue;
    ++complete;
    CHECK(run.counts.complex_up_to_reflection == 4u);
  }
  CHECK(complete >= 4);
  for (std::uint64_t seed = 1; seed <= 14; ++seed) check_never_wrong(solved(plane, "monodromy", seed), 4, 4);
}

// p on a circle about the line through three of the fixed points.
TEST_CASE("a circle of solutions is no empty list") {
  const ProblemStatement circle = problem_of(
      R"("dimension": 3, "points": ["f", "g", "h", "k", "p"],
      "fixed": {"f": [0, 0, 0], "g": [4, 0, 0], "h": [8, 0, 0], "k": [0, 5, 0]})",
      {{"p", "f", "25"}, {"p", "g", "9"}, {"p", "h", "25"}});
  for (const std::string strategy : {"polyhedral", "monodromy", "plan-scan"}) {
    CAPTURE(strategy);
    CHECK(solved(circle, strategy).status != RunStatus::complete);
  }
}

// Two points at height z over (or under) the plane of three, on the same side or on both: their distances
// differ by z² only. By construction both classes are there.
TEST_CASE("nearly flat figures on the same side and on both are two classes") {
  const ProblemStatement plane =
      problem_of(R"("dimension": 2, "points": ["p1", "p2", "p3", "p4"])", {{"p1", "p2", "16"},
                                                                           {"p1", "p3", "1.0000000001"},
                                                                           {"p2", "p4", "1.0000000001"},
                                                                           {"p2", "p3", "9.0000000001"},
                                                                           {"p1", "p4", "9.0000000001"}});
  for (const std::string strategy : {"plan-scan", "monodromy", "polyhedral"}) {
    CAPTURE(strategy);
    const SolveRun run = solved(plane, strategy, 1, {{"reduce", "off"}});
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.real_up_to_reflection == 2u);
  }
  const std::string points = R"("dimension": 3, "points": ["a", "b", "c", "p", "q"])";
  const std::vector<Length> base{{"a", "b", "16"}, {"a", "c", "10"}, {"b", "c", "18"}};
  const auto with_height = [&](const char* pa, const char* pb, const char* pc, const char* qa, const char* qb,
                               const char* qc) {
    std::vector<Length> lengths = base;
    lengths.insert(
        lengths.end(),
        {{"p", "a", pa}, {"p", "b", pb}, {"p", "c", pc}, {"q", "a", qa}, {"q", "b", qb}, {"q", "c", qc}});
    return problem_of(points, lengths);
  };
  // p = (0, 2, z), q = (3, 2, z) over a = (0, 0), b = (4, 0), c = (1, 3).
  const ProblemStatement real = with_height("4.0000000004", "20.0000000004", "2.0000000004", "13.0000000004",
                                            "5.0000000004", "5.0000000004");
  const ProblemStatement complex = with_height("3.9999999996", "19.9999999996", "1.9999999996",
                                               "12.9999999996", "4.9999999996", "4.9999999996");
  for (const std::string strategy : {"plan-scan", "monodromy", "polyhedral"})
    for (const std::string reduce : {"on", "off"}) {
      CAPTURE(strategy, reduce);
      const SolveRun run = solved(real, strategy, 1, {{"reduce", reduce}});
      CHECK(run.status == RunStatus::complete);
      CHECK(run.counts.real_up_to_reflection == 2u);
      const SolveRun other = solved(complex, strategy, 1, {{"reduce", reduce}});
      CHECK(other.status == RunStatus::complete);
      CHECK(other.counts.real_up_to_reflection == 0u);
      if (strategy != "plan-scan") CHECK(other.counts.complex_up_to_reflection == 2u);
    }
}

// p9 hangs on p8 and on two points that p8 hangs on, whose distance depends on the sides that others take. 16
// by the enumeration of all sides, one point after another.
TEST_CASE("a point is placed anew when a side changes the base of what it hangs on") {
  const auto given = [](const char* from, const char* to, double length) {
    DistanceConstraint constraint;
    constraint.between = {from[1] - '1', to[1] - '1'};
    constraint.given = {length, ""};
    return constraint;
  };
  ProblemStatement problem;
  for (int i = 1; i <= 9; ++i) problem.points.push_back("p" + std::to_string(i));
  problem.constraints = {given("p1", "p2", 4.14),  given("p1", "p3", 6.91), given("p2", "p3", 3.07),
                         given("p4", "p1", 5.87),  given("p4", "p2", 3.48), given("p4", "p3", 4.27),
                         given("p5", "p1", 3.68),  given("p5", "p2", 1.71), given("p5", "p3", 4.63),
                         given("p6", "p1", 7.24),  given("p6", "p2", 5.45), given("p6", "p4", 2.74),
                         given("p7", "p1", 12.22), given("p7", "p3", 7.03), given("p7", "p5", 9.7),
                         given("p8", "p1", 4.67),  given("p8", "p6", 6.21), given("p8", "p7", 10.14),
                         given("p9", "p6", 4.36),  given("p9", "p7", 3.75), given("p9", "p8", 6.68)};
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
    problem.constraints[i].id = "a" + std::to_string(i);
  for (const std::string reduce : {"on", "off"}) {
    CAPTURE(reduce);
    const SolveRun run = solved(problem, "plan-scan", 1, {{"reduce", reduce}});
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.real_up_to_reflection == 16u);
    CHECK(run.failed_checks.empty());
  }
}

// Two octahedra share a triangle with sides 1, 2 and 3: the whole turns about that line. Of each alone the real solution is
// double, and three points may span a plane with an isotropic normal in complex ones, which no frame of these three holds:
// cayley-menger, which has no frame, finds as many.
TEST_CASE("octahedra that are joined at collinear points turn about them, and one alone does not") {
  const std::vector<Length> one{{"a", "b", "1"},  {"a", "c", "9"},    {"b", "c", "4"},    {"b", "Ad", "3"},
                                {"c", "Ad", "3"}, {"a", "Ae", "5"},   {"c", "Ae", "20"},  {"a", "Af", "6"},
                                {"b", "Af", "5"}, {"Ad", "Ae", "11"}, {"Ad", "Af", "10"}, {"Ae", "Af", "9"}};
  std::vector<Length> both = one;
  both.insert(both.end(), {{"b", "Bd", "5"},
                           {"c", "Bd", "9"},
                           {"a", "Be", "9"},
                           {"c", "Be", "6"},
                           {"a", "Bf", "10"},
                           {"b", "Bf", "11"},
                           {"Bd", "Be", "11"},
                           {"Bd", "Bf", "18"},
                           {"Be", "Bf", "33"}});
  const ProblemStatement alone =
      problem_of(R"("dimension": 3, "points": ["a", "b", "c", "Ad", "Ae", "Af"])", one);
  const ProblemStatement joined =
      problem_of(R"("dimension": 3, "points": ["a", "b", "c", "Ad", "Ae", "Af", "Bd", "Be", "Bf"])", both);
  for (const std::string strategy : {"polyhedral", "monodromy"})
    for (const std::string reduce : {"on", "off"}) {
      CAPTURE(strategy, reduce);
      const SolveRun run = solved(joined, strategy, 1, {{"reduce", reduce}});
      CHECK(run.status == RunStatus::partial);
      CHECK(run.reason.find("it seems to move") != std::string::npos);
      CHECK(run.failed_checks.empty());
    }
  for (const std::string strategy : {"cayley-menger", "polyhedral", "monodromy"}) {
    CAPTURE(strategy);
    const SolveRun run = solved(alone, strategy);
    CHECK(run.status == RunStatus::complete);
    check_never_wrong(run, 1, 7);
  }
}

// Eight classes of the octahedron, four of them real. The point beside it, 3e-7 or 1e-7 over the plane of
// three others, is on either side, or on none in the reals: each class counts twice.
TEST_CASE("a point next to the plane that it hangs on is on either side of it") {
  const auto problem = [](const char* square) {
    return problem_of(R"("dimension": 3, "points": ["a", "b", "c", "A", "B", "C", "h"])", {{"a", "b", "16"},
                                                                                           {"a", "c", "10"},
                                                                                           {"a", "B", "5"},
                                                                                           {"a", "C", "17"},
                                                                                           {"b", "c", "18"},
                                                                                           {"b", "A", "21"},
                                                                                           {"b", "C", "9"},
                                                                                           {"c", "A", "21"},
                                                                                           {"c", "B", "5"},
                                                                                           {"A", "B", "44"},
                                                                                           {"A", "C", "40"},
                                                                                           {"B", "C", "36"},
                                                                                           {"h", "a", square},
                                                                                           {"h", "b", "5"},
                                                                                           {"h", "c", "5"}});
  };
  for (const std::string strategy : {"polyhedral", "monodromy", "cayley-menger"})
    for (const std::string reduce : {"on", "off"}) {
      CAPTURE(strategy, reduce);
      for (const char* square : {"5.0000000000001", "5.00000000000001", "5.000000000000000001"}) {
        const SolveRun run = solved(problem(square), strategy, 1, {{"reduce", reduce}});
        CHECK(run.status == RunStatus::complete);
        check_never_wrong(run, 8, 16);
      }
      const SolveRun run = solved(problem("4.99999999999999"), strategy, 1, {{"reduce", reduce}});
      CHECK(run.status == RunStatus::complete);
      check_never_wrong(run, 0, 16);
    }
}

// Four lines that touch four spheres lie next to each of three: they come apart like the root of what is
// added to a squared radius, and are real for more and complex for less.
TEST_CASE("tangents next to fourfold ones are twelve") {
  const ProblemStatement exact = load_instance("tangents-fourfold").problem;
  for (const auto& [square, real] : {std::pair("2.0000000000001", 12), std::pair("1.999999999999", 0)})
    for (const std::string strategy : {"polyhedral", "monodromy", "sphere-tangents"}) {
      CAPTURE(square, strategy);
      ProblemStatement problem = exact;
      problem.constraints.front().given = {std::stod(square), square};
      REQUIRE(problem.constraints.front().is_squared);
      const SolveRun run = solved(problem, strategy);
      CHECK(run.status == RunStatus::complete);
      check_never_wrong(run, static_cast<std::uint64_t>(real), 12);
    }
}
