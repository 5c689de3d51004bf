#include "solvers/reduction/hung_point.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/model/complex_points.hpp"
#include "solvers/tests/grown_graphs.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Points 0, 1 and, hung on them, 2, in the plane, with lengths as a file writes them.
ProblemStatement triangle(const std::string& base, const std::string& first, const std::string& second) {
  ProblemStatement problem = samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {1, 1, 1});
  const std::array texts{base, first, second};
  for (std::size_t i = 0; i < 3; ++i) problem.constraints[i].given = {std::stod(texts[i]), texts[i]};
  return problem;
}

const Part third_on_first_two{{0, 1}, {0}, {2}, {1, 2}};

HungPlace place_of(const ProblemStatement& problem) {
  return exact_place(Scene(problem), third_on_first_two);
}

}  // namespace

TEST_CASE("coordinates in a base give the point back, and are the same wherever the base is") {
  RandomNumbers random(1);
  for (int trial = 0; trial < 100; ++trial)
    for (const int dimension : {2, 3}) {
      const Simplex base = random.points(dimension, dimension, 1).cast<std::complex<double>>();
      const Eigen::Vector3cd point = random.point(dimension, 1).cast<std::complex<double>>();
      const SimplexCoordinates coordinates = SimplexFrame(base).coordinates(point);
      CHECK((SimplexFrame(base).point(coordinates) - point).norm() < 1e-12);
      // A rotation by a complex angle about the z-axis, and a translation.
      const std::complex<double> angle(random.uniform(-1, 1), random.uniform(-1, 1));
      Eigen::Matrix3cd turn = Eigen::Matrix3cd::Identity();
      turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      const Eigen::Vector3cd shift(1, 2, dimension == 3 ? 3 : 0);
      const Simplex moved = (turn * base).colwise() + shift;
      const Eigen::Vector3cd moved_point = turn * point + shift;
      CHECK((SimplexFrame(moved).coordinates(moved_point) - coordinates).norm() < 1e-9 * coordinates.norm());
    }
}

TEST_CASE("a triangle of the lengths 3, 4, 5 has a right angle") {
  const HungPlace place = place_of(triangle("3", "4", "5"));
  CHECK(place.is_real);
  CHECK_FALSE(place.is_flat);
  CHECK(place.coordinates[0] == 0.0);
  CHECK(place.coordinates[2].real() == Approx(4.0 / 3));  // of the base
}

TEST_CASE("whether a point is flat is decided by the decimals") {
  CHECK(place_of(triangle("0.3", "0.1", "0.2")).is_flat);
  const HungPlace above = place_of(triangle("0.3", "0.1", "0.2000000000000000000000000000000001"));
  CHECK_FALSE(above.is_flat);
  CHECK(above.is_real);
  // Heron: over the side 0.3, the triangle of 0.1, 0.2 + ε and 0.3 has the height² 2 · 0.1 · 0.2 · ε/0.3 but
  // for terms of higher order.
  CHECK(above.coordinates[2].real() * 0.3 == Approx(std::sqrt(2 * 0.1 * 0.2 / 0.3 * 1e-34)).epsilon(1e-9));
  const HungPlace below = place_of(triangle("0.3", "0.1", "0.1999999999999999999999999999999999"));
  CHECK_FALSE(below.is_real);
  CHECK_FALSE(below.is_flat);
  CHECK(below.undecided.empty());
}

TEST_CASE("measured and given bases give the same place") {
  RandomNumbers random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const ProblemStatement problem = samples::between(3, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}},
                                                      random.points(3, 4, 1), random.points(3, 4, 1));
    const Scene scene(problem);
    const Part hung{{0, 1, 2}, {0, 1, 2}, {3}, {3, 4, 5}};
    REQUIRE(hung.has_given_base());
    const HungPlace exact = exact_place(scene, hung);
    // A base of the target's lengths, by the cosine theorem.
    const auto& length = scene.target_lengths();
    Simplex base = Simplex::Zero(3, 3);
    base(0, 1) = length[0];
    base(0, 2) = (length[0] * length[0] + length[1] * length[1] - length[2] * length[2]) / (2 * length[0]);
    base(1, 2) = std::sqrt(length[1] * length[1] - base(0, 2) * base(0, 2));
    const HungPlace measured = measured_place(scene, hung, base);
    if (!measured.undecided.empty()) continue;
    CHECK(measured.is_real == exact.is_real);
    CHECK((measured.coordinates - exact.coordinates).norm() <= 1e-6 * exact.coordinates.norm());
    Simplex positions(3, 4);
    positions << base, SimplexFrame(base).point(exact.coordinates);
    BasePlacer(scene).refine(hung, positions);
    for (int i = 0; i < 3; ++i)
      CHECK(std::abs(squared_distance(ComplexPoints(positions), i, 3) - length[3 + i] * length[3 + i]) <
            1e-14);
  }
}

TEST_CASE("a point that is flat to rounding, or on a collinear base, is not placed") {
  const Scene scene(samples::between(3, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}},
                                     RandomNumbers(5).points(3, 4, 1), [] {
                                       Eigen::Matrix3Xd flat = RandomNumbers(6).points(3, 4, 1);
                                       flat.row(2).setZero();
                                       return flat;
                                     }()));
  Eigen::Matrix3Xd flat = RandomNumbers(6).points(3, 4, 1);
  flat.row(2).setZero();
  flat *= std::ldexp(1.0, -scene.unit_exponent());
  const Part hung{{0, 1, 2}, {0, 1, 2}, {3}, {3, 4, 5}};
  CHECK(measured_place(scene, hung, flat.leftCols(3).cast<std::complex<double>>())
            .undecided.find("in the plane") != std::string::npos);
  Simplex line = Simplex::Zero(3, 3);
  line(0, 1) = 1;
  line(0, 2) = 2;
  CHECK(measured_place(scene, hung, line).undecided.find("collinear") != std::string::npos);
}

TEST_CASE(
    "a point is not placed on three whose plane has an isotropic normal in it, or two of which are at the "
    "distance 0") {
  const Scene scene(samples::between(3, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}},
                                     RandomNumbers(5).points(3, 4, 1), RandomNumbers(6).points(3, 4, 1)));
  const Part hung{{0, 1, 2}, {-1, -1, -1}, {3}, {3, 4, 5}};
  const std::complex<double> i(0, 1);
  Simplex base = Simplex::Zero(3, 3);
  base.col(1) << 0.7, 0, 0;
  base.col(2) << 0.3, 1e3, 1e3 * i;
  CHECK(measured_place(scene, hung, base).undecided.find("collinear") != std::string::npos);
  base.col(1) << 0, 0.5, 0.5 * i;
  base.col(2) << 0.3, 0.2, 0.1;
  CHECK(measured_place(scene, hung, base).undecided.find("the distance 0") != std::string::npos);
}
