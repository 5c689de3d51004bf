/// Scenes with given points and a free line, restated without given points, and the way back.

#include "solvers/model/released_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Complex = std::complex<double>;

/// A line beside four given points, and one more point that hangs on the first three.
struct Placement {
  Eigen::Matrix3Xd given;
  ComplexLine line;
  Eigen::Vector3d free;

  ComplexPoints points() const {
    ComplexPoints all(3, given.cols() + 1);
    all << given.cast<Complex>(), free.cast<Complex>();
    return all;
  }
};

Placement random_placement(RandomNumbers& random, bool is_real) {
  Placement placement{random.points(3, 4, 0.3), {}, random.point(3, 1)};
  placement.given.rightCols<3>() += Eigen::Matrix3d::Identity();  // a tetrahedron that is not flat
  placement.line.point = random.point(3, 1).cast<Complex>();
  placement.line.direction = random.point(3, 1).cast<Complex>();
  if (!is_real) {
    placement.line.point.imag() = random.point(3, 1);
    placement.line.direction.imag() = random.point(3, 1);
  }
  placement.line = normalised(placement.line);
  return placement;
}

/// The problem that the placement solves; of a complex line the distances are some others.
ProblemStatement problem_of(const Placement& placement) {
  const int given = static_cast<int>(placement.given.cols());
  ProblemStatement problem;
  problem.lines = {"L"};
  problem.fixed_lines.resize(1);
  const auto add = [&](int a, int b, double length) {
    problem.constraints.push_back({"", {a, b}, {length, ""}});
  };
  const Eigen::Vector3d direction = placement.line.direction.real();
  for (int i = 0; i <= given; ++i) {
    problem.points.push_back("p" + std::to_string(i));
    if (i < given)
      problem.fixed_points.emplace_back(Eigen::Vector3d(placement.given.col(i)));
    else
      problem.fixed_points.emplace_back();
  }
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d w = placement.given.col(i) - placement.line.point.real();
    add(i, given + 1, w.cross(direction).norm() / direction.norm());
  }
  for (int i = 0; i < 3; ++i) add(i, given, (placement.given.col(i) - placement.free).norm());
  return problem;
}

/// Points and line as a figure of the scene, in its unit and frame.
Figure framed(const Scene& free, const ComplexPoints& points, const ComplexLine& line, bool is_real) {
  const double unit = std::ldexp(1.0, -free.unit_exponent());
  return free.in_frame(figure_of(points * unit, {{line.point * unit, line.direction}}, is_real));
}

/// With the other sign of any coordinates.
Figure mirrored(Figure figure, RandomNumbers& random) {
  for (int axis = 0; axis < 3; ++axis) {
    const int sign = random.sign();
    figure.points.row(axis) *= sign;
    if (figure.imaginary.cols() > 0) figure.imaginary.row(axis) *= sign;
  }
  return figure;
}

bool is_figure_of(const Placement& placement, bool is_real, const Figure& figure) {
  const ComplexLine line = complex_lines(figure)[0];
  const auto turn = [&](int sign) {
    return (line.direction - sign * placement.line.direction).norm() / line.direction.norm();
  };
  return figure.is_real() == is_real && figure.points.leftCols<4>() == placement.given &&
         (complex_points(figure) - placement.points()).norm() <= 1e-11 &&
         (line.point - placement.line.point).norm() <= 1e-11 * (1 + line.point.norm()) &&
         std::min(turn(1), turn(-1)) <= 1e-11;
}

/// In the plane z = height.
Placement mirror_image(Placement placement, double height) {
  placement.given.row(2) = (2 * height - placement.given.row(2).array()).matrix();
  placement.free[2] = 2 * height - placement.free[2];
  placement.line.point[2] = 2 * height - placement.line.point[2];
  placement.line.direction[2] *= -1;
  placement.line = normalised(placement.line);
  return placement;
}

/// A point with its distances from three others, in the order of the constraints.
struct Tie {
  std::array<int, 3> others{};
  std::array<Complex, 3> squares{};

  std::array<Eigen::Vector3cd, 3> places(const ComplexPoints& points) const {
    return {points.col(others[0]), points.col(others[1]), points.col(others[2])};
  }
};

/// By the first three constraints of the problem that name the point second.
Tie tie_of(const ProblemStatement& problem, int point) {
  Tie tie;
  std::size_t count = 0;
  for (const DistanceConstraint& constraint : problem.constraints) {
    if (constraint.between[1] != point || count == 3) continue;
    tie.others[count] = constraint.between[0];
    tie.squares[count++] = constraint.given.value;
  }
  REQUIRE(count == 3);
  return tie;
}

Eigen::Vector3cd mirror_image(const Eigen::Vector3cd& point, const std::array<Eigen::Vector3cd, 3>& plane) {
  const Eigen::Vector3cd normal = cross_product(plane[1] - plane[0], plane[2] - plane[0]);
  const Eigen::Vector3cd offset = point - plane[0];
  return point - normal * (2.0 * bilinear_product(normal, offset) / bilinear_product(normal, normal));
}

}  // namespace

TEST_CASE("a placement among four given points comes back from all its mirror images") {
  RandomNumbers random(4);
  for (int i = 0; i < 40; ++i) {
    const bool is_real = i % 2 == 0;
    const Placement placement = random_placement(random, is_real);
    const Scene given = Scene::unchecked(problem_of(placement));
    const ReleasedScene released(given);
    REQUIRE(released.doublings() == 0);
    const Figure figure = framed(released.scene(), placement.points(), placement.line, is_real);
    if (is_real) CHECK(relative_residual(released.scene(), figure) <= 1e-13);
    const auto back = released.carried_back(mirrored(figure, random));
    REQUIRE(back);
    CHECK(is_figure_of(placement, is_real, given.in_file_unit(*back)));
  }
}

TEST_CASE("coplanar given points are tied to one off their plane, and the wrong mirror image is dropped") {
  RandomNumbers random(5);
  for (int i = 0; i < 40; ++i) {
    const bool is_real = i % 2 == 0;
    Placement placement = random_placement(random, is_real);
    placement.given.row(2).setConstant(0.3);
    const Scene given = Scene::unchecked(problem_of(placement));
    const ReleasedScene released(given);
    REQUIRE(released.doublings() == 1);
    const Scene& free = released.scene();
    REQUIRE(free.point_count() == 6);
    ComplexPoints points(3, 6);
    points.leftCols<5>() = placement.points();
    const Tie added = tie_of(free.problem(), 5);
    int itself = 0, image = 0;
    const std::array<Eigen::Vector3cd, 2> places = trilaterate(added.places(points), added.squares).value();
    for (const Eigen::Vector3cd& place : places) {
      points.col(5) = place;
      const Figure figure = framed(free, points, placement.line, is_real);
      if (is_real) CHECK(relative_residual(free, figure) <= 1e-13);
      const auto back = released.carried_back(mirrored(figure, random));
      REQUIRE(back);
      itself += is_figure_of(placement, is_real, given.in_file_unit(*back));
      image += is_figure_of(mirror_image(placement, 0.3), is_real, given.in_file_unit(*back));
    }
    CHECK(itself == 1);
    CHECK(image == 1);

    const int attached = free.problem().constraints.back().between[1];
    const Tie tie = tie_of(free.problem(), attached);
    points.col(attached) = mirror_image(points.col(attached), tie.places(points));
    CHECK_FALSE(released.carried_back(mirrored(framed(free, points, placement.line, is_real), random)));
  }
}

TEST_CASE("the base is far from flat however flat or narrow the given points are") {
  RandomNumbers random(7);
  for (int i = 0; i < 40; ++i) {
    Placement placement = random_placement(random, true);
    const double flatness = std::pow(10, -(i % 5));
    if (i >= 10) placement.given.row(2) *= flatness;
    if (i >= 20) placement.given.row(1) *= flatness;
    const ProblemStatement problem = problem_of(placement);
    const Scene given = Scene::unchecked(problem);
    const ReleasedScene released(given);
    const ProblemStatement& free = released.scene().problem();
    // Of the base 0 1 2 3 the edges 01, 02, 12, 03, 13, 23; the first is the longest distance given.
    const auto square = [&](std::size_t k) {
      return free.constraints[problem.constraints.size() + k].given.value;
    };
    const double a = square(0), b = square(1), c = square(3);
    const double ab = a + b - square(2), ac = a + c - square(4), bc = b + c - square(5);
    Eigen::Matrix3d gram;
    gram << 2 * a, ab, ac, ab, 2 * b, bc, ac, bc, 2 * c;
    const double volume = std::sqrt((gram / a).determinant() / 8);  // 6 times that of the tetrahedron
    INFO(i << ": " << volume);
    CHECK(volume >= 0.99e-4);  // heights of a hundredth
  }
}

TEST_CASE("points on one line or in one place, and a given line, are refused") {
  RandomNumbers random(6);
  Placement placement = random_placement(random, true);
  CHECK_FALSE(why_not_released(Scene::unchecked(problem_of(placement))));
  ProblemStatement with_line = problem_of(placement);
  with_line.fixed_lines[0] = LinePosition{};
  CHECK(why_not_released(Scene::unchecked(with_line)));
  placement.given.col(3) = placement.given.col(0);
  CHECK(why_not_released(Scene::unchecked(problem_of(placement))));
  placement.given.bottomRows<2>().setZero();
  placement.given.row(0) << 0, 1, 2.5, 4;
  CHECK(why_not_released(Scene::unchecked(problem_of(placement))));
}
