#include <catch2/catch.hpp>
#include <set>

#include "solvers/counting/laman_graphs.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

Answer solved(const ProblemStatement& problem, const OptionMap& options = {}) {
  return solve(Scene(problem), "monodromy", options, {.certify = true});
}

ProblemStatement with_unit_lengths(int points, const Edges& edges) {
  return problem_of(2, points, edges, std::vector<double>(edges.size(), 1));
}

/// The largest error of a squared length, by the lengths and the figure alone.
double largest_error(const ProblemStatement& problem, const Figure& figure) {
  const ComplexPoints points = complex_points(figure);
  double error = 0;
  for (const DistanceConstraint& constraint : problem.constraints)
    error = std::max(error, std::abs(squared_distance(points, constraint.between[0], constraint.between[1]) -
                                     constraint.length() * constraint.length()));
  return error;
}

/// Two points a, b at distance 1 from x, y and z, of which x and y are at distance 1: where a = b, z goes round them.
/// Otherwise a and b are the two points next to x and y, at a distance of √3, and z is x or y.
const Edges five_points{{0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}};

/// Two regular triangles, corresponding corners at distance 1.
const Edges prism{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};

}  // namespace

TEST_CASE("where two points coincide the rest moves, beside isolated solutions") {
  const ProblemStatement problem = with_unit_lengths(5, five_points);
  for (const char* reduce : {"on", "off"}) {
    INFO(reduce);
    const Answer answer = solved(problem, {{"reduce", reduce}});
    CHECK(answer.status == RunStatus::infinite);
    CHECK_THAT(answer.reason, Catch::Contains("a curve where p1 = p2"));
    REQUIRE(answer.motions.size() == 1);
    const Motion& motion = answer.motions[0];
    CHECK(motion.coincident == std::vector<std::array<int, 2>>{{0, 1}});
    CHECK(motion.dimension == 1);
    CHECK(motion.is_exact);
    CHECK(motion.figure.is_real());
    CHECK(largest_error(problem, motion.figure) < 1e-12);
    REQUIRE(answer.solutions.size() == 2);
    std::set<int> on;  // the one of x and y that z is at
    for (const AssessedSolution& solution : answer.solutions) {
      CHECK(solution.certified);
      CHECK((solution.point("p1") - solution.point("p2")).norm() == Approx(std::sqrt(3.0)));
      for (const int other : {3, 4})
        if ((solution.point("p5") - solution.point("p" + std::to_string(other))).norm() < 1e-12)
          on.insert(other);
    }
    CHECK(on == std::set<int>{3, 4});
    CHECK(answer.failed_checks.empty());
  }
}

TEST_CASE("a prism of regular triangles with equal bars moves as a parallelogram does") {
  const ProblemStatement problem = with_unit_lengths(6, prism);
  const Answer answer = solved(problem);
  CHECK(answer.status == RunStatus::infinite);
  REQUIRE_FALSE(answer.motions.empty());
  for (const Motion& motion : answer.motions) {
    CHECK(motion.coincident.empty());
    CHECK_FALSE(motion.parallel.empty());
    CHECK(motion.dimension == 1);
    CHECK(motion.is_exact);
    CHECK(motion.figure.is_real());
    CHECK(largest_error(problem, motion.figure) < 1e-12);
  }
  // Elsewhere the second triangle is the first one turned by ±120 degrees about its centre, or its image by a reflection at
  // one of the three lines that all corners are equally far from (√3/4) and a glide of ±1/2 along it.
  CHECK(answer.solutions.size() == 8);
  for (const AssessedSolution& solution : answer.solutions) CHECK((solution.certified && solution.is_real()));
}

TEST_CASE("a prism that nearly moves has only isolated solutions") {
  ProblemStatement problem = with_unit_lengths(6, prism);
  problem.constraints[6].given = {1.001, "1.001"};
  const Answer answer = solved(problem);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.motions.empty());
  CHECK_FALSE(answer.solutions.empty());
  for (const AssessedSolution& solution : answer.solutions) CHECK(solution.certified);
}

TEST_CASE("no minimally rigid graph of up to six points has unexplained ends where the Jacobian loses rank") {
  int infinite = 0, graphs = 0;
  for (const int points : {4, 5, 6})
    for (const Edges& edges : all_laman_graphs(points)) {
      const ProblemStatement problem = with_unit_lengths(points, edges);
      const Answer answer = solved(problem);
      ++graphs;
      INFO("points " << points << ", graph " << graphs << ": " << answer.reason);
      CHECK_THAT(answer.reason, !Catch::Contains("loses rank"));
      CHECK((answer.status == RunStatus::infinite) == !answer.motions.empty());
      infinite += answer.status == RunStatus::infinite;
      for (const Motion& motion : answer.motions) CHECK(largest_error(problem, motion.figure) < 1e-10);
    }
  CHECK(graphs == 1 + 3 + 13);  // OEIS A227117
  CHECK(infinite > 0);
}
