#include "solvers/figures/fold_solutions.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

/// p1 and p2 at distance 1, and p3 at 1/2 from p1 and 1/2 + δ from p2: a triangle for δ > 0 only, with p3 at
/// the height √(δ/2) but for the factor 1 + O(δ), by Heron's formula.
Scene narrow_triangle(const std::string& length) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.row(0) << 0, 1, 0.5;
  ProblemStatement problem = samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, points, points);
  problem.constraints[2].given = {0.5, length};
  return Scene(problem);
}

struct Outcome {
  std::optional<FoldSolutions> solutions;
  double unit = 1;  ///< the scene's, in the file's
};

/// From a point that is off by 1e-6 in both directions.
Outcome solve(const std::string& length) {
  const Scene scene = narrow_triangle(length);
  const DistanceSystem system(scene);
  const double unit = std::ldexp(1.0, scene.unit_exponent());
  Figure near{Eigen::Matrix3Xd::Zero(3, 3), {}};
  near.points.row(0) << 0, 1, 0.5 + 1e-6;
  near.points(1, 2) = 1e-6;
  near.points /= unit;
  WorkCounters work;
  return {solutions_at_fold(system, target_squares(scene), system.coordinates(near), work), unit};
}

}  // namespace

TEST_CASE("the two solutions next to an extremum of t are those of a narrow triangle") {
  const auto [length, height] = GENERATE(table<std::string, double>({
      {"0.50000001", std::sqrt(0.5e-8)},
      {"0.500000000000001", std::sqrt(0.5e-15)},
      {"0.50000000000000000001", std::sqrt(0.5e-20)},
      {"0.500000000000000000000000005", std::sqrt(2.5e-27)},
  }));
  CAPTURE(length);
  const Outcome found = solve(length);
  REQUIRE(found.solutions);
  REQUIRE(found.solutions->x.size() == 2);
  for (int i = 0; i < 2; ++i) {
    const Eigen::VectorXd& x = found.solutions->x[static_cast<std::size_t>(i)];
    const double side = (i == 0 ? -1 : 1) * (found.solutions->direction[2] > 0 ? 1 : -1);
    CHECK(x[2] * found.unit == Approx(side * height).epsilon(1e-2));
    CHECK(x[1] * found.unit == Approx(0.5).epsilon(1e-7));
  }
}

TEST_CASE("there is no solution next to an extremum of t where a triangle cannot be") {
  const std::string length =
      GENERATE("0.49999999", "0.499999999999999", "0.49999999999999999999", "0.499999999999999999999999995");
  CAPTURE(length);
  const Outcome found = solve(length);
  REQUIRE(found.solutions);
  CHECK(found.solutions->x.empty());
}

TEST_CASE("solutions closer to an extremum of t than rounding are not told from none") {
  CHECK_FALSE(solve("0.5").solutions);
  CHECK_FALSE(solve("0.50000000000000000000000000000001").solutions);
  CHECK_FALSE(solve("0.49999999999999999999999999999999").solutions);
}
