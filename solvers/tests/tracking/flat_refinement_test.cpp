/// A point on two circles whose centres all but coincide: along them distances change by 1e-13 of the way.

#include "solvers/tracking/flat_refinement.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/elements/scene_system.hpp"
#include "solvers/model/distance_equations.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/tracking/real_equations.hpp"

using namespace gcs;

namespace {

/// p at distance 1 from a and, where it is (0.3, √0.91), from b = (ε, 0): |p − b|² = 1 − 0.6·ε + ε².
Scene with_close_centres() {
  Problem problem(2);
  problem.points("a", "b", "p");
  problem.distance("a", "b", "1e-13").distance("a", "p", "1");
  problem.squared_distance("b", "p", "0.99999999999994000000000001");
  return Scene(problem);
}

}  // namespace

TEST_CASE("a solution is found along circles that all but coincide") {
  const Scene scene = with_close_centres();
  const DistanceSystem system(scene);
  const double unit = std::ldexp(1, -scene.unit_exponent());
  const int x = system.unknown(2, 0), y = system.unknown(2, 1), b = system.unknown(1, 0);
  Eigen::VectorXd exact(3);
  exact[x] = 0.3 * unit;
  exact[y] = std::sqrt(0.91) * unit;
  exact[b] = 1e-13 * unit;
  for (const double turned : {0.0, 1e-6, 1e-4, -1e-3}) {
    Eigen::VectorXd near = exact;
    near[x] = std::cos(turned) * exact[x] - std::sin(turned) * exact[y];
    near[y] = std::sin(turned) * exact[x] + std::cos(turned) * exact[y];
    const auto found = flat_refinement(WideEquations(distance_equations(scene, system)), near, 0.01 * unit);
    CAPTURE(turned);
    REQUIRE(found);
    // 1e-32 in double-double is 1e-19 along the circles; what is left is rounding to doubles.
    CHECK((*found - exact).lpNorm<Eigen::Infinity>() <= 0x1p-52 * unit);
  }
}

TEST_CASE("the equations of elements lead to the same solution") {
  const Scene scene = with_close_centres();
  const SceneSystem system(scene);
  const double unit = std::ldexp(1, -scene.unit_exponent());
  Figure exact{Eigen::Matrix3Xd::Zero(3, 3), {}};
  exact.points.col(1) = Eigen::Vector3d(1e-13, 0, 0) * unit;
  exact.points.col(2) = Eigen::Vector3d(0.3, std::sqrt(0.91), 0) * unit;
  for (const double turned : {0.0, 1e-6, 1e-4, -1e-3}) {
    Figure near = exact;
    near.points.col(2) = Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()) * exact.points.col(2);
    const auto found =
        flat_refinement(WideEquations(system.equations()), real_parts(system.coordinates(near)), 0.01 * unit);
    CAPTURE(turned);
    REQUIRE(found);
    const Figure figure = system.figure(ComplexValues(found->begin(), found->end()), true);
    CHECK((figure.points - exact.points).lpNorm<Eigen::Infinity>() <= 0x1p-52 * unit);
  }
}

TEST_CASE("no solution is found where steps along circles would be too long") {
  const Scene scene = with_close_centres();
  const DistanceSystem system(scene);
  const double unit = std::ldexp(1, -scene.unit_exponent());
  Eigen::VectorXd near(3);
  near[system.unknown(2, 0)] = 0.4 * unit;
  near[system.unknown(2, 1)] = std::sqrt(0.84) * unit;
  near[system.unknown(1, 0)] = 1e-13 * unit;
  CHECK_FALSE(flat_refinement(WideEquations(distance_equations(scene, system)), near, 0.01 * unit));
}
