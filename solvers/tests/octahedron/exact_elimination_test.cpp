#include "solvers/octahedron/exact_elimination.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/octahedron/exact_squares.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

/// With coordinates of a few bits, so that squared distances are exact doubles.
Eigen::Matrix3Xd short_coordinates(RandomNumbers& numbers) {
  return Eigen::Matrix3Xd::NullaryExpr(
      3, 6, [&](Eigen::Index, Eigen::Index) { return std::round(numbers.uniform(-256, 256)) / 256; });
}

/// The sample octahedron with the distances of other points, exactly, times `unit`, a power of two.
ProblemStatement octahedron_of(const Eigen::Matrix3Xd& points, double unit = 1) {
  ProblemStatement problem = samples::octahedron();
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    constraint.given = {unit * unit * (points.col(a) - points.col(b)).squaredNorm(), ""};
    constraint.is_squared = true;
  }
  problem.sketch.reset();
  return problem;
}

Octahedron core_of(const Scene& scene) {
  return *find_octahedron(scene.problem(), reduce_to_core(scene.problem(), {}));
}

/// With the pairs in any order and the points of each swapped or not: 48.
std::vector<Octahedron> relabelled(const Octahedron& octahedron) {
  std::vector<Octahedron> all;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (int swaps = 0; swaps < 8; ++swaps) {
      Octahedron turned;
      for (std::size_t i = 0; i < 3; ++i) {
        turned.pair[i] = octahedron.pair[order[i]];
        if (swaps & (1 << i)) std::swap(turned.pair[i][0], turned.pair[i][1]);
      }
      all.push_back(turned);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

/// In the scene's unit.
Rational exact_square(const Scene& scene, const Eigen::Matrix3Xd& points, const std::array<int, 2>& pair) {
  return Rational::from_double((points.col(pair[0]) - points.col(pair[1])).squaredNorm())
      .times_power_of_two(-2 * scene.unit_exponent());
}

/// Six times the volume of four points, in the scene's unit.
Rational exact_volume(const Scene& scene, const Eigen::Matrix3Xd& points, const std::array<int, 4>& corners) {
  std::array<std::array<Rational, 3>, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      v[i][static_cast<std::size_t>(axis)] =
          Rational::from_double(points(axis, corners[i + 1]) - points(axis, corners[0]));
  const auto minor = [&](std::size_t i, std::size_t j) { return v[1][i] * v[2][j] - v[1][j] * v[2][i]; };
  return (v[0][0] * minor(1, 2) - v[0][1] * minor(0, 2) + v[0][2] * minor(0, 1))
      .times_power_of_two(-3 * scene.unit_exponent());
}

}  // namespace

TEST_CASE("of an octahedron in general position 16 roots are left, and that of known points is one exactly") {
  RandomNumbers numbers(1);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Matrix3Xd points = short_coordinates(numbers);
    const Scene scene(octahedron_of(points));
    const Octahedron octahedron = core_of(scene);
    const OctahedronPolynomials polynomials = eliminated(scene, octahedron);
    CHECK(polynomials.diagonal.degree() == 8);
    CHECK(polynomials.height.degree() == 16);
    CHECK(polynomials.diagonal.value(exact_square(scene, points, octahedron.pair[0])).is_zero());
    const auto [a, a2] = octahedron.pair[0];
    const Rational volume =
        exact_volume(scene, points, {a, octahedron.pair[1][0], octahedron.pair[2][0], a2});
    CHECK(polynomials.height.value(volume).is_zero());
    CHECK(polynomials.height.value(Rational(0) - volume).is_zero());
    CHECK_FALSE(polynomials.height.value(volume + Rational::from_decimal("1e-20")).is_zero());
    REQUIRE(polynomials.real_solutions());
    CHECK(*polynomials.real_solutions() >= 2);  // the points and their mirror image
  }
}

TEST_CASE("how many real octahedra there are depends on no name and no unit") {
  RandomNumbers numbers(2);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Matrix3Xd points = short_coordinates(numbers);
    const Scene scene(octahedron_of(points)), large(octahedron_of(points, 0x1p90));
    const std::optional<int> count = eliminated(scene, core_of(scene)).real_solutions();
    REQUIRE(count);
    for (const Octahedron& octahedron : relabelled(core_of(scene)))
      CHECK(eliminated(scene, octahedron).real_solutions() == count);
    CHECK(eliminated(large, core_of(large)).real_solutions() == count);
  }
}

TEST_CASE("another unknown leaves as many real roots") {
  RandomNumbers numbers(7);
  for (int i = 0; i < 3; ++i) {
    const Scene scene(octahedron_of(short_coordinates(numbers)));
    const Octahedron octahedron = core_of(scene);
    CHECK(separated_real_solutions(scene, octahedron) == eliminated(scene, octahedron).real_solutions());
  }
}

// With b and c, b' and c' exchanged the lengths are the same: a solution (|aa'|, |bb'|, |cc'|) comes with
// (|aa'|, |cc'|, |bb'|), and both share |aa'|, but not |bb'|.
TEST_CASE("another unknown tells the solutions of an octahedron with a symmetry apart") {
  RandomNumbers numbers(8);
  int shared = 0;
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3Xd points = short_coordinates(numbers);
    const Octahedron octahedron = core_of(Scene(octahedron_of(points)));
    for (const int p : octahedron.pair[0]) points(0, p) = 0;
    for (std::size_t end = 0; end < 2; ++end) {
      points.col(octahedron.pair[2][end]) = points.col(octahedron.pair[1][end]);
      points(0, octahedron.pair[2][end]) *= -1;
    }
    const Scene scene(octahedron_of(points));
    Octahedron by_other = octahedron;
    std::swap(by_other.pair[0], by_other.pair[1]);
    const std::optional<int> count = separated_real_solutions(scene, octahedron);
    REQUIRE(count);
    CHECK(*count == separated_real_solutions(scene, by_other).value_or(-1));  // by other determinants
    shared += !eliminated(scene, octahedron).real_solutions();
  }
  CHECK(shared > 0);
}

TEST_CASE("coplanar diagonals leave the number open, whatever the unknown") {
  RandomNumbers numbers(9);
  Eigen::Matrix3Xd points = short_coordinates(numbers);
  const Octahedron octahedron = core_of(Scene(octahedron_of(points)));
  for (std::size_t i = 0; i < 2; ++i)
    for (const int p : octahedron.pair[i]) points(2, p) = 0;
  const Scene scene(octahedron_of(points));
  CHECK_FALSE(eliminated(scene, octahedron).real_solutions());
  CHECK_FALSE(separated_real_solutions(scene, octahedron));
}

TEST_CASE("an octahedron that flexes leaves no polynomial") {
  RandomNumbers numbers(4);
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3Xd points = short_coordinates(numbers);
    const Octahedron octahedron = core_of(Scene(octahedron_of(points)));
    for (const auto& [a, a2] : octahedron.pair)  // Bricard's first type: a half turn
      points.col(a2) << -points(0, a), -points(1, a), points(2, a);
    const Scene scene(octahedron_of(points));
    const OctahedronPolynomials polynomials = eliminated(scene, octahedron);
    CHECK(polynomials.diagonal.is_zero());
    CHECK(polynomials.height.is_zero());
    CHECK_FALSE(polynomials.real_solutions());
  }
}

TEST_CASE("each pair of diagonals at infinity takes a root with it, mirror images two") {
  RandomNumbers numbers(5);
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3Xd points = short_coordinates(numbers);
    const Octahedron octahedron = core_of(Scene(octahedron_of(points)));
    const auto [b, b2] = octahedron.pair[1];
    const auto [c, c2] = octahedron.pair[2];
    points.col(c2) = points.col(b) + points.col(b2) - points.col(c);  // a parallelogram b c b' c'
    const Scene scene(octahedron_of(points));
    const OctahedronPolynomials polynomials = eliminated(scene, octahedron);
    CHECK(polynomials.diagonal.degree() == 8 - stretched_walks(scene, octahedron));
    CHECK(polynomials.height.degree() == 2 * polynomials.diagonal.degree());
    CHECK(polynomials.diagonal.degree() < 8);
  }
}

TEST_CASE("a flat octahedron is no simple solution, and its number is left open") {
  RandomNumbers numbers(6);
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3Xd points = short_coordinates(numbers);
    points.row(2).setZero();
    const Scene scene(octahedron_of(points));
    const OctahedronPolynomials polynomials = eliminated(scene, core_of(scene));
    REQUIRE_FALSE(polynomials.height.is_zero());
    CHECK(polynomials.height.value(Rational(0)).is_zero());
    CHECK_FALSE(polynomials.real_solutions());
  }
}
