/// All solutions in a box, on triangles whose third point has two positions close together.

#include "solvers/certificates/box_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/certificates/scene_equations.hpp"

using namespace gcs;

namespace {

/// Base 2; the third point is at (1, ±height), whose square is given in decimals.
ProblemStatement flat_triangle(const std::string& squared_side) {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"a", "b", "c"};
  const Decimal side{std::stod(squared_side), squared_side};
  problem.constraints = {
      {"a1", {0, 1}, {2, ""}, false}, {"a2", {0, 2}, side, true}, {"a3", {1, 2}, side, true}};
  problem.reference = Reference{0, 1, -1, -1, -1};
  return problem;
}

enum class Equations { of_distances, quadratic };

/// In a box that holds (1, 0) and all points next to it.
std::optional<std::vector<Box>> around_foot(const std::string& squared_side, double radius,
                                            Equations equations = Equations::of_distances) {
  constexpr int most_parts = 2000;
  const Scene scene(flat_triangle(squared_side));
  REQUIRE(scene.size() == 1);  // the unit is the base
  const DistanceSystem system(scene);
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 3);
  figure.points(0, 1) = 1;
  figure.points(0, 2) = 0.5;
  const Eigen::VectorXd mid = system.coordinates(figure);
  const Box box{mid, Eigen::VectorXd::Constant(mid.size(), radius)};
  if (equations == Equations::of_distances)
    return solutions_in(system, target_squares(scene), box, most_parts);
  const IntervalEquations quadratic(SceneEquations(scene).system());
  return solutions_in(KrawczykTest(quadratic, scene.size()), box, most_parts);
}

}  // namespace

TEST_CASE("solutions that the doubles of the lengths do not tell apart are found each") {
  struct Flat {
    std::string squared_side;
    double height;
  };
  const std::vector<Flat> triangles{
      {"1.000001", 1e-3}, {"1.000000000000000001", 1e-9}, {"1.0000000000000000000001", 1e-11}};
  for (const Equations equations : {Equations::of_distances, Equations::quadratic})
    for (const auto& [squared_side, height] : triangles) {
      INFO(squared_side);
      const auto found = around_foot(squared_side, 1e-2, equations);
      REQUIRE(found);
      REQUIRE(found->size() >= 2);
      int above = 0, below = 0;
      for (const Box& box : *found) {
        const double y = box.mid[2], radius = box.radius[2];
        CHECK(std::abs(std::abs(y) - height / 2) <= radius);  // in units of the base
        CHECK(radius < height / 2);
        (y > 0 ? above : below) += 1;
      }
      CHECK(above >= 1);
      CHECK(below >= 1);
    }
}

TEST_CASE("a box without a real solution is proven to have none") {
  for (const Equations equations : {Equations::of_distances, Equations::quadratic}) {
    const auto found = around_foot("0.999999999999999999", 1e-2, equations);
    REQUIRE(found);
    CHECK(found->empty());
  }
}

TEST_CASE("a double solution is not decided") {
  for (const Equations equations : {Equations::of_distances, Equations::quadratic})
    CHECK_FALSE(around_foot("1", 1e-2, equations));
}
