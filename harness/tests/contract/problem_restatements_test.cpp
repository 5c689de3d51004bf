#include "harness/tests/contract/problem_restatements.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/scene.hpp"

using namespace gcs;
using namespace gcs::contract;

TEST_CASE("a decimal times a power of two is exact") {
  CHECK(times_power_of_two("3", 0) == "3");
  CHECK(times_power_of_two("3", 2) == "12");
  CHECK(times_power_of_two("3", -1) == "1.5");
  CHECK(times_power_of_two("0.10", 3) == "0.80");
  CHECK(times_power_of_two("2.5", 2) == "10.0");
  CHECK(times_power_of_two("0.3", -3) == "0.0375");
  CHECK(times_power_of_two("1", -20) == "0.00000095367431640625");
  CHECK(times_power_of_two("7.25", 40) == "7971459301376.00");
}

TEST_CASE("a decimal and its double are scaled alike") {
  for (const int exponent : {-80, -40, -3, 5, 40, 80})
    CHECK(std::stod(times_power_of_two("2.1050", exponent)) == std::ldexp(2.1050, exponent));
}

TEST_CASE("a restated figure leads back to the original one") {
  const ProblemStatement problem = load_instance("octahedron").problem;
  const Figure& sketch = *problem.sketch;
  std::mt19937_64 random(1);
  for (const Restatement& restatement : {relabelled(problem, random), constraints_permuted(problem, random),
                                         mirrored(problem), ends_swapped(problem)}) {
    INFO(restatement.name);
    CHECK(restatement.original(*restatement.problem.sketch).points == sketch.points);
  }
}

TEST_CASE("every restatement restates something") {
  const ProblemStatement problem = load_instance("octahedron").problem;
  std::mt19937_64 random(1);
  const Restatement labels = relabelled(problem, random);
  const ProblemStatement& names = labels.problem;
  CHECK(names.points[0] != problem.points[0]);
  CHECK(names.constraints[0].between != problem.constraints[0].between);
  CHECK(names.constraints[0].given.value == problem.constraints[0].given.value);
  CHECK(names.reference->origin == labels.point_now[problem.reference->origin]);

  const ProblemStatement order = constraints_permuted(problem, random).problem;
  CHECK(order.constraints[0].id != problem.constraints[0].id);
  CHECK(order.constraints[order.interpolation.bent].id == problem.constraints.back().id);

  CHECK(mirrored(problem).problem.sketch->points(0, 3) == -problem.sketch->points(0, 3));
  CHECK(ends_swapped(problem).problem.constraints[4].between[0] == problem.constraints[4].between[1]);

  const ProblemStatement larger = scaled(problem, 5).problem;
  CHECK(larger.constraints[0].given.value == 32 * problem.constraints[0].given.value);
  CHECK(larger.interpolation.bend == 64);
  CHECK(Scene(larger).unit_exponent() == Scene(problem).unit_exponent() + 5);
}

TEST_CASE("bends by polynomials are restated with their constraints") {
  ProblemStatement problem = load_instance("octahedron").problem;
  problem.interpolation.bends = {{3, {1, -0.5}}, {8, {0.25}}};
  std::mt19937_64 random(1);
  const ProblemStatement order = constraints_permuted(problem, random).problem;
  const std::vector<BentLength>& bends = *order.interpolation.bends;
  REQUIRE(bends.size() == 2);
  CHECK(order.constraints[bends[0].constraint].id == problem.constraints[3].id);
  CHECK(order.constraints[bends[1].constraint].id == problem.constraints[8].id);
  CHECK(scaled(problem, 5).problem.interpolation.bends->front().coefficients == std::vector<double>{32, -16});
}

TEST_CASE("squared lengths and fixed positions are restated too") {
  const ProblemStatement squared = load_instance("disulfide").problem;
  CHECK(scaled(squared, -3).problem.constraints[0].given.value == squared.constraints[0].given.value / 64);
  const ProblemStatement anchored = load_instance("tangents-durand").problem;
  std::mt19937_64 random(1);
  const Restatement names = relabelled(anchored, random);
  for (std::size_t i = 0; i < anchored.points.size(); ++i)
    CHECK(names.problem.fixed_points[names.point_now[i]] == anchored.fixed_points[i]);
  CHECK(scaled(anchored, 5).problem.fixed_points[1]->isApprox(32 * *anchored.fixed_points[1], 0));
  CHECK(mirrored(anchored).problem.fixed_points[1]->x() == -anchored.fixed_points[1]->x());
}

TEST_CASE("random targets are the lengths of a placement") {
  std::mt19937_64 random(1);
  const ProblemStatement problem = load_instance("disulfide").problem;
  const ProblemStatement once = with_random_targets(problem, random);
  const ProblemStatement again = with_random_targets(problem, random);
  CHECK(once.constraints[0].given.value != again.constraints[0].given.value);
  CHECK(once.constraints[0].is_squared);
}
