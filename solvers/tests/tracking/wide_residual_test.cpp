/// Residuals in double-double see moves far below the rounding of residuals in doubles: the slow twin is the derivative.
#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/general_curve.hpp"
#include "solvers/tracking/plan_curve.hpp"
#include "solvers/tracking/released_curve.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Relative to the sizes of the numbers, whose rounding is 2^-53.
constexpr double move_size = 0x1p-48;
/// What the move's own square and the rounding of the points it is taken between leave of the derivative's agreement.
constexpr double agreement = 1e-6;

/// By how much a difference of two residuals misses what the derivative says, relative to that.
double miss(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
            const Eigen::VectorXd& by_derivative) {
  return (after - before - by_derivative).norm() / by_derivative.norm();
}

Eigen::VectorXd moved_slightly(Eigen::VectorXd y, RandomNumbers& random) {
  for (double& value : y) value += move_size * random.uniform(-1, 1);
  return y;
}

struct Misses {
  double wide = 0;
  double in_doubles = 0;
};

template <class Family>
Misses misses(Family family, RandomNumbers& random) {
  const Eigen::Index m = family.unknowns();
  const Eigen::VectorXd here = family.start(), there = moved_slightly(here, random);
  Eigen::MatrixXd jacobian(m, m + 1);
  family.jacobian(here, jacobian);
  const Eigen::VectorXd by_derivative = jacobian * (there - here);
  Eigen::VectorXd before(m), after(m);
  family.wide_residual(here, before);
  family.wide_residual(there, after);
  Misses result;
  result.wide = miss(before, after, by_derivative);
  family.residual(here, before);
  family.residual(there, after);
  result.in_doubles = miss(before, after, by_derivative);
  return result;
}

GeneralFamily general_family(const Scene& scene) {
  const SceneSystem system(scene);
  return {scene, system, sketched_unknowns(scene, system).value().x, 12};
}

/// With the values that the sketch has.
ReleasedFamily released_family(const Scene& scene, Eigen::Index released) {
  const SceneSystem system(scene);
  RealEquations equations = real_equations(system.equations());
  const Eigen::VectorXd x = sketched_unknowns(scene, system).value().x;
  equations.given = equations.sums(x);
  return ReleasedFamily::at_solution(equations, system.equations().mirror, released, x, 12);
}

}  // namespace

TEST_CASE("residuals in double-double see moves below the rounding of those in doubles") {
  RandomNumbers random(1);
  double worst_in_doubles = 0;
  for (int sample = 0; sample < 20; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 5 + random.index(4), random));
    const Misses by_family[] = {
        misses(DistanceFamily(scene, scene.reference(), 12), random), misses(general_family(scene), random),
        misses(released_family(scene, random.index(scene.constraint_count())), random)};
    for (const Misses& one : by_family) {
      CHECK(one.wide < agreement);
      worst_in_doubles = std::max(worst_in_doubles, one.in_doubles);
    }
  }
  CHECK(worst_in_doubles > 1e-3);
}

// The points of a plan are rounded, and with them the removed distances.
TEST_CASE("residuals of a plan in double-double see moves below the rounding of its points") {
  RandomNumbers random(2);
  double worst_in_doubles = 0;
  int judged = 0;
  for (int sample = 0; sample < 40; ++sample) {
    const Scene scene(samples::random_problem(2 + sample % 2, 5 + random.index(4), random));
    const ExchangeRule rule{0.2, true};
    Plan plan = derive_plan(scene, *scene.sketch(), rule);
    const Figure sketch = in_plan_frame(scene, plan, *scene.sketch());
    change_plan(plan, rule, sketch.points);
    PlanCurve curve(scene, plan, sketch, {});
    if (plan.driving_parameters() == 0 || boundary_distance(plan, rule, sketch.points) < 0.1) continue;
    ++judged;
    curve.read_parameters(sketch.points, 0);
    const Eigen::VectorXd here = curve.parameters(), there = moved_slightly(here, random);
    REQUIRE(curve.evaluate());
    curve.differentiate();
    const Eigen::VectorXd by_derivative = curve.reduced_jacobian() * (there - here);
    const Eigen::Index d = plan.driving_parameters();
    Eigen::VectorXd before(d), after(d), wide_before(d), wide_after(d);
    curve.residual(before);
    curve.wide_residual(wide_before);
    curve.parameters() = there;
    REQUIRE(curve.evaluate());
    curve.residual(after);
    curve.wide_residual(wide_after);
    CHECK(miss(wide_before, wide_after, by_derivative) < agreement);
    worst_in_doubles = std::max(worst_in_doubles, miss(before, after, by_derivative));
  }
  CHECK(judged >= 10);
  CHECK(worst_in_doubles > 1e-3);
}
