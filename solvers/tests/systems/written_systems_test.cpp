/// The systems of Hoffmann and Yuan at figures whose coordinates are known exactly.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/systems/homogeneous_bound.hpp"
#include "solvers/systems/octahedron_systems.hpp"
#include "solvers/systems/pyramid_systems.hpp"
#include "solvers/systems/system_paths.hpp"
#include "solvers/systems/tangent_systems.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Of a few bits, so that squared distances are exact doubles; not 0.
double short_number(RandomNumbers& numbers) {
  return numbers.sign() * (1 + std::floor(numbers.uniform(0, 256))) / 256;
}

Eigen::Matrix3Xd short_coordinates(int points, RandomNumbers& numbers) {
  return Eigen::Matrix3Xd::NullaryExpr(3, points,
                                       [&](Eigen::Index, Eigen::Index) { return short_number(numbers); });
}

ProblemStatement with_squares_of(ProblemStatement problem, const Eigen::Matrix3Xd& points, double unit) {
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    const double square = b < points.cols() ? (points.col(a) - points.col(b)).squaredNorm()
                                            : points.col(a).tail<2>().squaredNorm();
    constraint.given = {unit * unit * square, ""};
    constraint.is_squared = true;
  }
  problem.sketch.reset();
  return problem;
}

Octahedron core_of(const Scene& scene) {
  return *find_octahedron(scene.problem(), reduce_to_core(scene.problem(), {}));
}

/// With a at 0, b on the x-axis and c in the xy-plane.
Eigen::Matrix3Xd octahedron_points(const Octahedron& octahedron, RandomNumbers& numbers) {
  Eigen::Matrix3Xd points = short_coordinates(6, numbers);
  points.col(octahedron.pair[0][0]).setZero();
  points.col(octahedron.pair[1][0]).tail<2>().setZero();
  points(2, octahedron.pair[2][0]) = 0;
  return points;
}

Rational exactly(double value, const Scene& scene, int power = 1) {
  return Rational::from_double(value).times_power_of_two(-power * scene.unit_exponent());
}

bool vanishes(const RationalPolynomial& equation, const std::vector<Rational>& zero) {
  return equation.value(zero).is_zero();
}

bool is_zero_of(const PolynomialSystem& system, const std::vector<Rational>& zero) {
  return std::ranges::all_of(system.equations,
                             [&](const RationalPolynomial& equation) { return vanishes(equation, zero); });
}

Natural volume(const PolynomialSystem& system) {
  const auto found = mixed_volume(supports_of(system), 1, 1, {});
  REQUIRE(found);
  return *found;
}

/// Distances of five points (the apex last) from the line, from the apex and around.
ProblemStatement pyramid_of(const Eigen::Matrix3Xd& points, double unit = 1) {
  ProblemStatement problem = samples::problem_of(3, 5, {}, {});
  problem.lines = {"L"};
  const auto add = [&](int a, int b) {
    problem.constraints.push_back({"c" + std::to_string(problem.constraints.size()), {a, b}, {}, true});
  };
  for (int p = 0; p < 5; ++p) add(p, 5);
  for (int p = 0; p < 4; ++p) add(4, p);
  for (int p = 0; p < 4; ++p) add(p, (p + 1) % 4);
  return with_squares_of(problem, points, unit);
}

Eigen::Matrix3Xd pyramid_points(RandomNumbers& numbers) {
  Eigen::Matrix3Xd points = short_coordinates(5, numbers);
  points.col(4) << 0, 0, std::abs(points(2, 4));
  return points;
}

std::vector<Rational> parametrised_zero(const Eigen::Matrix3Xd& p, const Scene& scene) {
  std::vector<Rational> zero;
  for (const double value :
       {p(0, 0), p(1, 0), p(2, 0), p(0, 1), p(1, 1), p(0, 3), p(1, 3), p(0, 2), p(1, 2), p(2, 2)})
    zero.push_back(exactly(value, scene));
  return zero;
}

}  // namespace

TEST_CASE("known points are zeros of an octahedron's quadrics and determinants, exactly") {
  RandomNumbers numbers(1);
  for (const double unit : {1.0, 0x1p60}) {
    const Octahedron octahedron =
        core_of(Scene(with_squares_of(samples::octahedron(), short_coordinates(6, numbers), 1)));
    const Eigen::Matrix3Xd points = octahedron_points(octahedron, numbers);
    const Scene scene(with_squares_of(samples::octahedron(), points, unit));
    const SystemOrReason written = octahedron_quadrics(scene, octahedron);
    REQUIRE(written.system);
    const double b = points(0, octahedron.pair[1][0]), c = points(1, octahedron.pair[2][0]);
    std::vector<Rational> zero;
    for (const auto& [corner, free] : octahedron.pair) {
      zero.push_back(exactly(unit * unit * b * points(0, free), scene, 2));
      zero.push_back(exactly(unit * unit * c * points(1, free), scene, 2));
      zero.push_back(exactly(unit * points(2, free), scene));
    }
    CHECK(is_zero_of(written.system->equations, zero));
    const PolynomialSystem eliminated = echelon_form(written.system->equations);
    CHECK(is_zero_of(eliminated, zero));
    zero[2] = zero[2] + Rational(1);
    CHECK_FALSE(is_zero_of(eliminated, zero));
    std::vector<Rational> squares;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [p, q] = octahedron.pair[i];
      squares.push_back(exactly(unit * unit * (points.col(p) - points.col(q)).squaredNorm(), scene, 2));
    }
    CHECK(is_zero_of(octahedron_determinants(scene, octahedron), squares));
  }
}

// Three equations of degree 2 in two of three unknowns each: 2·2·2·2 zeros by Bézout on P¹ × P¹ × P¹, which are the
// configurations that a platform of this kind has (Lazard, Merlet 1994).
TEST_CASE("an octahedron in general position has 16 zeros by every bound but Bézout's") {
  RandomNumbers numbers(2);
  for (int i = 0; i < 3; ++i) {
    const Scene scene(with_squares_of(samples::octahedron(), short_coordinates(6, numbers), 1));
    const Octahedron octahedron = core_of(scene);
    const SystemOrReason quartics = octahedron_quartics(scene, octahedron),
                         quadrics = octahedron_quadrics(scene, octahedron);
    REQUIRE(quartics.system);
    CHECK(quartics.system->equations.total_degree() == Natural(64));
    CHECK(volume(quartics.system->equations) == Natural(16));
    CHECK(small_homogeneous_bound(supports_of(quartics.system->equations)).bound == Natural(16));
    CHECK(quadrics.system->equations.total_degree() == Natural::power_of_two(9));
    const PolynomialSystem determinants = octahedron_determinants(scene, octahedron);
    CHECK(determinants.total_degree() == Natural(16));
    CHECK(small_homogeneous_bound(supports_of(determinants)).bound == Natural(8));
  }
}

TEST_CASE("the quartics say how far the points at two half angles are off their distance") {
  RandomNumbers numbers(3);
  const Scene scene(with_squares_of(samples::octahedron(), short_coordinates(6, numbers), 1));
  const Octahedron octahedron = core_of(scene);
  const WrittenSystem written = *octahedron_quartics(scene, octahedron).system;
  for (int i = 0; i < 20; ++i) {
    std::vector<Rational> exact;
    ComplexVectorX t;
    for (int k = 0; k < 3; ++k) {
      t.emplace_back(numbers.uniform(-3, 3));
      exact.push_back(Rational::from_double(t.back().real()));
    }
    const ComplexPoints points = written.place(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const int p = octahedron.pair[k][1], q = octahedron.pair[l][1];
      const double square = std::ldexp(
          [&] {
            for (const DistanceConstraint& c : scene.problem().constraints)
              if (std::minmax(c.between[0], c.between[1]) == std::minmax(p, q)) return c.given.value;
            return 0.0;
          }(),
          -2 * scene.unit_exponent());
      const double size = (1 + std::norm(t[k])) * (1 + std::norm(t[l]));
      const double wanted = size * (squared_distance(points, p, q).real() - square);
      CHECK(std::abs(written.equations.equations[k].value(exact).approximate() - wanted) <= 1e-11 * size);
    }
  }
}

TEST_CASE("known points are zeros of both systems of a pyramid, exactly") {
  RandomNumbers numbers(4);
  for (const double unit : {1.0, 0x1p-60}) {
    const Eigen::Matrix3Xd points = pyramid_points(numbers);
    const Scene scene(pyramid_of(points, unit));
    const Pyramid pyramid = *find_pyramid(scene);
    REQUIRE(pyramid.cycle == std::array{0, 1, 2, 3});
    std::vector<Rational> zero;
    for (int p = 0; p < 4; ++p)
      for (int axis = 0; axis < 3; ++axis) zero.push_back(exactly(unit * points(axis, p), scene));
    const WrittenSystem quadrics = *pyramid_quadrics(scene, pyramid).system;
    CHECK(quadrics.equations.total_degree() == Natural(4096));
    CHECK(is_zero_of(quadrics.equations, zero));
    CHECK(is_zero_of(echelon_form(quadrics.equations), zero));
    zero[4] = zero[4] * Rational(2);
    CHECK_FALSE(is_zero_of(quadrics.equations, zero));
    const WrittenSystem parametrised = *pyramid_parametrised(scene, pyramid).system;
    CHECK(is_zero_of(parametrised.equations, parametrised_zero(unit * points, scene)));
    ComplexVectorX approximate;
    for (const Rational& value : parametrised_zero(unit * points, scene))
      approximate.emplace_back(value.approximate());
    const double scale = std::ldexp(unit, -scene.unit_exponent());
    CHECK((parametrised.place(approximate) - (scale * points).cast<std::complex<double>>())
              .cwiseAbs()
              .maxCoeff() <= 1e-9 * scale);
  }
}

// With t = r5 the factor is 0 by which the equations were multiplied.
TEST_CASE("the parametrised system of a pyramid has zeros that are none of the problem's") {
  RandomNumbers numbers(5);
  Eigen::Matrix3Xd points = pyramid_points(numbers);
  points(2, 0) = points(2, 4);
  const Scene scene(pyramid_of(points));
  const WrittenSystem written = *pyramid_parametrised(scene, *find_pyramid(scene)).system;
  for (int i = 0; i < 5; ++i) {
    std::vector<Rational> zero = parametrised_zero(points, scene);
    for (const std::size_t first : {std::size_t{3}, std::size_t{5}}) {  // along the line x1 x + y1 y = k
      const Rational step = Rational::from_double(short_number(numbers));
      zero[first] = zero[first] + step * zero[1];
      zero[first + 1] = zero[first + 1] - step * zero[0];
    }
    CHECK(is_zero_of(written.equations, zero));
    ComplexVectorX approximate;
    for (const Rational& value : zero) approximate.emplace_back(value.approximate());
    CHECK(written.is_extraneous(approximate));
  }
}

TEST_CASE("a pyramid whose apex is on the line has no such system") {
  RandomNumbers numbers(6);
  Eigen::Matrix3Xd points = pyramid_points(numbers);
  points(2, 4) = 0;
  const Scene scene(pyramid_of(points));
  CHECK_FALSE(pyramid_quadrics(scene, *find_pyramid(scene)).system);
  CHECK_FALSE(pyramid_parametrised(scene, *find_pyramid(scene)).system);
}

TEST_CASE("a line that touches four spheres is a zero of both systems, exactly") {
  RandomNumbers numbers(7);
  const RationalVector u{Rational(2) / Rational(3), Rational(-1) / Rational(3), Rational(2) / Rational(3)};
  ExactSpheres spheres;
  for (ExactSphere& sphere : spheres)
    for (Rational& coordinate : sphere.center) coordinate = Rational::from_double(short_number(numbers));
  // p·u = 0 from the first centre.
  const Rational a = Rational::from_double(short_number(numbers)),
                 b = Rational::from_double(short_number(numbers));
  const RationalVector p{a, Rational(2) * a + Rational(2) * b, b};
  REQUIRE(dot(p, u).is_zero());
  for (ExactSphere& sphere : spheres) {
    const RationalVector from_line = sphere.center - spheres[0].center - p;
    const RationalVector moment = cross(from_line, u);
    sphere.square = dot(moment, moment);
  }
  const PolynomialSystem quadrics = tangent_quadrics(spheres);
  CHECK(quadrics.total_degree() == Natural(64));
  CHECK(is_zero_of(quadrics, {p[0], p[1], p[2], u[0], u[1], u[2]}));
  const std::optional<PolynomialSystem> cubic = tangent_cubic(spheres);
  REQUIRE(cubic);
  CHECK(cubic->total_degree() == Natural(24));
  CHECK(is_zero_of(*cubic, {u[0], u[1], u[2]}));
  for (ExactSphere& sphere : spheres) sphere.center[2] = sphere.center[0] + sphere.center[1];
  CHECK_FALSE(tangent_cubic(spheres));
}
