/// All solutions in a box, on triangles whose third point has two positions close together.

#include "solvers/certificates/box_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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

/// In a box that holds (1, 0) and all points next to it.
std::optional<std::vector<Box>> around_foot(const std::string& squared_side, double radius) {
  const Scene scene(flat_triangle(squared_side));
  REQUIRE(scene.size() == 1);  // the unit is the base
  const DistanceSystem system(scene);
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 3);
  figure.points(0, 1) = 1;
  figure.points(0, 2) = 0.5;
  const Eigen::VectorXd mid = system.coordinates(figure);
  return solutions_in(system, target_squares(scene), {mid, Eigen::VectorXd::Constant(mid.size(), radius)},
                      2000);
}

}  // namespace

TEST_CASE("solutions that the doubles of the lengths do not tell apart are found each") {
  struct Flat {
    std::string squared_side;
    double height;
  };
  for (const auto& [squared_side, height] : {Flat{"1.000001", 1e-3}, Flat{"1.000000000000000001", 1e-9},
                                             Flat{"1.0000000000000000000001", 1e-11}}) {
    INFO(squared_side);
    const auto found = around_foot(squared_side, 1e-2);
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
  const auto found = around_foot("0.999999999999999999", 1e-2);
  REQUIRE(found);
  CHECK(found->empty());
}

TEST_CASE("a double solution is not decided") { CHECK_FALSE(around_foot("1", 1e-2)); }
