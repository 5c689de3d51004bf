/// Subdivision of whole scenes, against what theory says of them.

#include "solvers/subdivision/subdivision.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "solvers/solving/solve.hpp"
#include "solvers/strategies/box_subdivision.hpp"
#include "solvers/subdivision/distinct_solutions.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

constexpr Reduction reductions[] = {Reduction::none, Reduction::box, Reduction::linear};

Answer solved(const ProblemStatement& problem, Reduction reduction = Reduction::linear, int threads = 1) {
  return solve(Scene(problem), BoxSubdivision{.threads = threads, .reduce = false, .reduction = reduction});
}

/// Each further point is hung on the last three, or in the plane on the last two, so that its mirror image in
/// them is a solution as well: with the frame's mirror image divided out, 2^(points − dimension − 1) in all.
ProblemStatement chain(int dimension, int points, RandomNumbers& random) {
  samples::Edges edges;
  for (int p = 1; p < points; ++p)
    for (int q = std::max(0, p - dimension); q < p; ++q) edges.push_back({q, p});
  const Eigen::Matrix3Xd placed = random.points(dimension, points, 1);
  return samples::between(dimension, edges, placed, placed);
}

std::int64_t counted(const Answer& answer, const std::string& name) {
  for (const Particular& particular : answer.particulars)
    if (particular.name == name) return particular.value;
  return -1;
}

/// The circles around the ends of a base of length 3 in the plane, of the radii 1 and 2, touch where c is; d
/// hangs on a and c.
ProblemStatement touching_circles(double from_a) {
  return samples::problem_of(2, 4, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {2, 3}}, {3, 1, 2, from_a, 1.25});
}

}  // namespace

TEST_CASE("of a chain of hung points every reduction proves all positions") {
  RandomNumbers random(1977);
  for (const auto& [dimension, points] : {std::pair{2, 4}, {2, 6}, {3, 5}, {3, 6}})
    for (const Reduction reduction : reductions) {
      if (reduction == Reduction::none && points > 5) continue;  // takes minutes
      const Answer answer = solved(chain(dimension, points, random), reduction);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.claim == Claim::all_real);
      CHECK(answer.solutions.size() == std::size_t{1} << (points - dimension - 1));
      CHECK(answer.failed_checks.empty());
    }
}

TEST_CASE("linear programs spare boxes, and equations do") {
  const auto boxes = [](Reduction reduction) { return counted(solved(samples::k33(), reduction), "boxes"); };
  CHECK(boxes(Reduction::linear) < boxes(Reduction::box));
  CHECK(boxes(Reduction::box) < boxes(Reduction::none));
}

TEST_CASE("circles that touch do so once, and circles that miss each other by a little do not") {
  // d is at the height 3/4 over a: the solution has fractions for coordinates.
  const Answer touching = solved(touching_circles(0.75));
  CHECK(touching.status == RunStatus::complete);
  REQUIRE(touching.solutions.size() == 1);
  CHECK(touching.solutions[0].multiplicity == 2);
  CHECK(touching.failed_checks.empty());
  const Eigen::Matrix3Xd points = touching.solutions[0].placement().points;
  CHECK((points.col(0) - points.col(2)).norm() == Approx(1).epsilon(1e-15));
  CHECK((points.col(0) - points.col(3)).norm() == Approx(0.75).epsilon(1e-15));

  ProblemStatement apart = touching_circles(0.75);
  apart.constraints[0].given.value += 0x1p-26;  // no placement at all
  const Answer none = solve(Scene::unchecked(apart), BoxSubdivision{.reduce = false});
  CHECK(none.status == RunStatus::complete);
  CHECK(none.solutions.empty());
  apart.constraints[0].given.value -= 0x1p-25;  // c 1e-4 beside the base
  const Answer two = solve(Scene::unchecked(apart), BoxSubdivision{.reduce = false});
  CHECK(two.status == RunStatus::complete);
  CHECK(two.solutions.size() == 2);
}

TEST_CASE("circles that touch are undecided where no fractions say that they do") {
  const Answer touching = solved(touching_circles(1.5));
  CHECK(touching.status == RunStatus::partial);
  CHECK_THAT(touching.reason, Catch::Contains("undecided"));
  CHECK(counted(touching, "undecided_boxes") > 0);
  // Of c, beside a on the base, d is known on one side of it, and both are one class.
  REQUIRE(touching.solutions.size() == 1);
  const Eigen::Matrix3Xd points = touching.solutions[0].placement().points;
  CHECK((points.col(0) - points.col(2)).norm() == Approx(1));
  CHECK((points.col(1) - points.col(2)).norm() == Approx(2));
  CHECK(touching.solutions[0].multiplicity > 1);
}

// Two triangles that are translates of each other, and three bars of one length between them: one goes around
// the other.
TEST_CASE("where a scene moves the subdivision ends, and says why") {
  const ProblemStatement moving =
      samples::problem_of(2, 6, {{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}},
                          {3, 4, 5, 3, 4, 5, 2, 2, 2});
  const Answer answer = solved(moving);
  CHECK((answer.status == RunStatus::gave_up || answer.status == RunStatus::partial));
  CHECK_THAT(answer.reason, Catch::Contains("unlikely to be isolated"));
}

TEST_CASE("any number of threads gives the same bits, and a unit of 2^k the same boxes") {
  RandomNumbers random(1995);
  const ProblemStatement problem = chain(3, 6, random);
  const Answer one = solved(problem);
  const Answer three = solved(problem, Reduction::linear, 3);
  ProblemStatement scaled = problem;
  scaled.sketch.reset();
  for (DistanceConstraint& c : scaled.constraints) c.given.value = std::ldexp(c.given.value, 300);
  const Answer large = solved(scaled);
  CHECK(one.particulars == three.particulars);
  CHECK(one.particulars == large.particulars);
  REQUIRE(one.solutions.size() == three.solutions.size());
  for (std::size_t i = 0; i < one.solutions.size(); ++i)
    CHECK(one.solutions[i].placement().points == three.solutions[i].placement().points);
}

TEST_CASE("a subdivision that gives up says how many boxes are left") {
  RandomNumbers random(1999);
  const Answer answer = solve(Scene(chain(3, 7, random)), BoxSubdivision{.reduce = false, .max_boxes = 20});
  CHECK((answer.status == RunStatus::gave_up || answer.status == RunStatus::partial));
  CHECK_THAT(answer.reason, Catch::Contains("more boxes than max_boxes allows"));
  CHECK(counted(answer, "boxes") == 20);
  CHECK(counted(answer, "boxes_left") > 0);
}

TEST_CASE("solutions are told apart by their enclosures, and mirror images are one") {
  const auto at = [](double x, double y, double radius, double unique) {
    return ProvenSolution{{Eigen::Vector2d(x, y), Eigen::Vector2d::Constant(radius)},
                          Eigen::Vector2d::Constant(unique)};
  };
  const std::vector<int> mirror{0, 1};
  CHECK(mirror_signs(mirror).size() == 4);
  CHECK(mirror_signs({0, 0}).size() == 2);
  CHECK(mirror_signs({-1, -1}).size() == 1);
  CHECK(distinct_solutions({at(1, 2, 1e-9, 0.1), at(1, 2.05, 1e-9, 0.1)}, mirror).list.size() == 1);
  CHECK(distinct_solutions({at(1, 2, 1e-9, 0.1), at(-1, -2, 1e-9, 0.1)}, mirror).list.size() == 1);
  CHECK(distinct_solutions({at(1, 2, 1e-9, 0.1), at(-1, -2, 1e-9, 0.1)}, {-1, -1}).list.size() == 2);
  const DistinctSolutions open = distinct_solutions({at(1, 2, 0.05, 0.1), at(1, 2.06, 0.05, 0.1)}, mirror);
  CHECK(open.list.size() == 1);
  CHECK(open.undecided.size() == 1);
}
