#include "solvers/exploring/proven_neighbours.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "solvers/reading/instance_parser.hpp"

using namespace gcs;

namespace {

std::string distance(const std::string& a, const std::string& b, const std::string& length) {
  return R"({"type": "distance", "between": [")" + a + R"(", ")" + b + R"("], "length": )" + length + "}";
}

/// A rectangle p q u r with sides 3 and 4, and s at a distance of 2 from q and of `length` from r, which is 5 from q.
Scene beside_diagonal(const std::string& length) {
  return Scene(parse_instance(R"({"format": "gcsbench-instance/2", "id": "rectangle", "dimension": 2,
      "points": ["p", "q", "u", "r", "s"], "constraints": [)" +
                              distance("p", "q", "3") + ", " + distance("q", "u", "4") + ", " +
                              distance("p", "u", "5") + ", " + distance("p", "r", "4") + ", " +
                              distance("u", "r", "3") + ", " + distance("q", "s", "2") + ", " +
                              distance("r", "s", length) + "]}")
                   .problem);
}

/// With s on the diagonal from q to r.
Figure on_diagonal(const Scene& scene) {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 5);
  figure.points.row(0) << 0, 3, 3, 0, 1.8;
  figure.points.row(1) << 0, 0, 4, 4, 1.6;
  return scene.in_scene_unit(figure);
}

}  // namespace

TEST_CASE("both solutions next to a fold are proven, with their errors") {
  const Scene scene = beside_diagonal("3.000000000004");
  ProvenNeighbours neighbours(scene);
  const std::vector<Candidate> found = neighbours.of(on_diagonal(scene));
  REQUIRE(found.size() == 2);
  for (const Candidate& candidate : found) {
    const Eigen::Matrix3Xd points = scene.in_file_unit(candidate.figure).points;
    CHECK((points.col(4) - points.col(1)).norm() == Approx(2).epsilon(1e-15));
    CHECK((points.col(4) - points.col(3)).norm() == Approx(3.000000000004).epsilon(1e-15));
    CHECK(candidate.error < 1e-14);
  }
  // Off the diagonal by h on either side, where 5 = √(2² − h²) + √(3.000000000004² − h²): h² (1/4 + 1/6) = 4e-12.
  const double apart =
      (scene.in_file_unit(found[0].figure).points - scene.in_file_unit(found[1].figure).points).norm();
  CHECK(apart == Approx(2 * std::sqrt(4e-12 * 12 / 5)).epsilon(1e-3));
  CHECK(neighbours.nearest(on_diagonal(scene)).has_value());
  CHECK(neighbours.in_vain() == 0);
}

TEST_CASE("next to a double solution, and where none is real, there is none, which is found out once") {
  for (const std::string length : {"3", "2.999999999996"}) {
    const Scene scene = beside_diagonal(length);
    ProvenNeighbours neighbours(scene);
    CHECK(neighbours.of(on_diagonal(scene)).empty());
    CHECK_FALSE(neighbours.nearest(on_diagonal(scene)));
    CHECK(neighbours.in_vain() == 1);
  }
}
