#include "solvers/tangents/strip.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "solvers/model/complex_lines.hpp"
#include "solvers/tangents/scene_spheres.hpp"
#include "solvers/tangents/squeeze_homotopy.hpp"
#include "solvers/tangents/strip_refinement.hpp"
#include "solvers/tangents/tangents_of_four_spheres.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

using Complex = std::complex<double>;
using Vector = SqueezeHomotopy::Vector;

FourSpheres random_strip(RandomNumbers& random, double breadth, double thickness) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(random.uniform(-3, 3), random.point(3, 1).normalized()).toRotationMatrix();
  FourSpheres spheres;
  for (Sphere& sphere : spheres) {
    sphere.center = turn * Eigen::Vector3d(1, breadth, thickness).asDiagonal() * random.point(3, 1);
    sphere.square = {random.uniform(0.1, 1), 0};
  }
  return spheres;
}

Complex random_complex(RandomNumbers& random) { return {random.uniform(-1, 1), random.uniform(-1, 1)}; }

Eigen::Vector3cd random_vector(RandomNumbers& random) {
  return {random_complex(random), random_complex(random), random_complex(random)};
}

ComplexSpheres random_complex_spheres(RandomNumbers& random) {
  ComplexSpheres spheres;
  for (int i = 0; i < 3; ++i) spheres.centers.col(i) = random_vector(random);
  spheres.squares = random_vector(random);
  spheres.first_square = random_complex(random);
  return spheres;
}

}  // namespace

TEST_CASE("isotropic coordinates keep products and lead back to double-double") {
  RandomNumbers random(1);
  for (int i = 0; i < 20; ++i) {
    const Strip strip(random_strip(random, 1e-3, 1e-3));
    const WideVector v = widened(random_vector(random)), w = widened(random_vector(random));
    const ComplexDoubleDouble product = v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
    const ComplexDoubleDouble same = isotropic_product(strip.isotropic(v), strip.isotropic(w));
    const double b = std::exp2(random.index(40) - 20);
    const ComplexDoubleDouble turned =
        isotropic_product(turned_by(b, strip.isotropic(v)), turned_by(b, strip.isotropic(w)));
    // A few roundings of 2⁻¹⁰⁴ of vectors of length 2 at most.
    constexpr double rounding = 1e-29;
    CHECK(std::abs((product - same).value()) <= rounding);
    CHECK(std::abs((product - turned).value()) <= rounding);
    const WideVector back = strip.cartesian(strip.isotropic(v));
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(std::abs((back[axis] - v[axis]).value()) <= rounding);
  }
}

TEST_CASE("widened spheres are off their axis by half of their length at least") {
  RandomNumbers random(2);
  for (double breadth = 0.25; breadth > 1e-9; breadth /= 8) {
    const FourSpheres spheres = random_strip(random, breadth, breadth * breadth);
    const Strip strip(spheres), wide(strip.widened_spheres());
    double length = 0, across = 0;
    for (const Sphere& a : spheres)
      for (const Sphere& b : spheres) length = std::max(length, (a.center - b.center).norm());
    for (const WideVector& center : strip.centers()) across = std::max(across, std::abs(center[1].value()));
    CHECK(strip.widening() * across <= length);
    CHECK(2 * strip.widening() * across > length);
    // Its own axis is another one, which leaves a factor.
    CHECK(wide.widening() <= 8);
  }
}

TEST_CASE("the squeeze homotopy's derivatives are those of its values") {
  RandomNumbers random(3);
  const ComplexSpheres from = random_complex_spheres(random), to = random_complex_spheres(random);
  const SqueezeHomotopy homotopy(from, to, {random_vector(random), random_vector(random)});
  // Central differences: values are polynomials of degree 4 at most, so the error is h² times coefficients.
  constexpr double h = 1e-5;
  for (int i = 0; i < 10; ++i) {
    Vector x;
    x << random_vector(random), random_vector(random);
    const Complex t = random_complex(random);
    const HomotopyValue<6> at = homotopy.at(x, t);
    const double size = 1 + at.jacobian.norm() + at.t_derivative.norm();
    for (int k = 0; k < 6; ++k) {
      const Vector step = h * Vector::Unit(k);
      const Vector slope = (homotopy.at(x + step, t).value - homotopy.at(x - step, t).value) / (2 * h);
      CHECK((slope - at.jacobian.col(k)).norm() <= 1e-7 * size);
    }
    const Vector in_t = (homotopy.at(x, t + h).value - homotopy.at(x, t - h).value) / (2 * h);
    CHECK((in_t - at.t_derivative).norm() <= 1e-7 * size);
  }
}

TEST_CASE("tangents are zeros of the squeeze homotopy at both ends and after a rotation") {
  RandomNumbers random(4);
  WorkCounters work;
  const FourSpheres spheres = LocalSpheres(random_strip(random, 1, 1)).spheres;
  const Strip strip(spheres);
  ComplexSpheres complex;
  for (int i = 0; i < 3; ++i) {
    complex.centers.col(i) = narrowed(strip.centers()[static_cast<std::size_t>(i)]);
    complex.squares[i] = spheres[static_cast<std::size_t>(i + 1)].square.value();
  }
  complex.first_square = spheres[0].square.value();
  const FoundTangents tangents = common_tangents(spheres, work);
  REQUIRE(tangents.lines.size() == 12);
  for (const FoundTangent& tangent : tangents.lines) {
    for (const double b : {1.0, 4.0}) {
      const ScaledLine line = ScaledLine::of(strip, tangent.line).turned(b).normalised();
      const ComplexSpheres other = random_complex_spheres(random);
      Vector x;
      x << line.direction, line.scaled_point;
      const SqueezeHomotopy away(complex.turned(b), other, line), towards(other, complex.turned(b), line);
      // Lines are found to 1e-14, times the size of the combined equations.
      CHECK(towards.at(x, 1).value.norm() <= 1e-10 * towards.at(x, 1).jacobian.norm());
      CHECK(away.at(x, 0).value.norm() <= 1e-10 * away.at(x, 0).jacobian.norm());
    }
  }
}

TEST_CASE("a line of a nearly isotropic direction is turned without being rounded") {
  // A coordinate's last bit is all of u·u: no doubles are nearer to a line's.
  const double a = std::exp2(26), near_a = std::nextafter(a, 2 * a);
  const ComplexLine line{{0, 1, Complex(0, 1)}, {-1, a, Complex(0, near_a)}};
  const ComplexLine turned = normalised(line);
  CHECK(turned.direction == Eigen::Vector3cd(-line.direction));
  CHECK(turned.point == line.point);
  CHECK(normalised(turned).direction == turned.direction);
}

TEST_CASE("isotropic coordinates of a rounded line are those of the line") {
  RandomNumbers random(5);
  WorkCounters work;
  for (const double width : {1e-4, 1e-6, 1e-8}) {
    const LocalSpheres local(random_strip(random, width, width));
    const Strip strip(local.spheres);
    const FoundTangents tangents = common_tangents(local.spheres, work);
    REQUIRE(tangents.lines.size() == 12);
    for (const FoundTangent& tangent : tangents.lines) {
      const ScaledLine start = ScaledLine::of(strip, tangent.line);
      const auto refined = refined_in_strip(local.spheres, strip, start, work);
      REQUIRE(refined);
      // Coordinates of up to 1/width and their rounding.
      CHECK(difference(refined->in_strip, start, strip.largest_rotation()) <= 1e-13 / width);
    }
  }
}
