#include "solvers/model/complex_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/figures/reflection_classes.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

using Complex = std::complex<double>;

ComplexPoints random_complex(RandomNumbers& numbers, int count) {
  ComplexPoints points(3, count);
  points.real() = numbers.points(3, count, 1);
  points.imag() = numbers.points(3, count, 1);
  return points;
}

}  // namespace

TEST_CASE("two points have a frame in space") {
  ComplexPoints points(3, 2);
  points << Complex(1, 2), Complex(2.25, 2), Complex(0, 1), Complex(0, 1.75), 3.0, 3.0;
  const ComplexPoints moved = in_frame(points, 3, {0, 1, -1});
  CHECK(moved.col(0).isZero(0));
  CHECK(moved.col(1).tail<2>().isZero(0));
  CHECK(std::abs(moved(0, 1) * moved(0, 1) - 1.0) <= 1e-15);  // 1.25² + (0.75 i)²
}

TEST_CASE("trilateration meets the three squares, on both sides") {
  RandomNumbers numbers(1);
  for (int i = 0; i < 100; ++i) {
    const ComplexPoints points = random_complex(numbers, 4);
    const auto both = trilaterate(
        {points.col(0), points.col(1), points.col(2)},
        {squared_distance(points, 3, 0), squared_distance(points, 3, 1), squared_distance(points, 3, 2)});
    REQUIRE(both);
    const double first = ((*both)[0] - points.col(3)).norm();
    const double second = ((*both)[1] - points.col(3)).norm();
    CHECK(std::min(first, second) <= 1e-11);
    for (const Eigen::Vector3cd& found : *both) {
      ComplexPoints other = points;
      other.col(3) = found;
      for (int center = 0; center < 3; ++center)
        CHECK(std::abs(squared_distance(other, 3, center) - squared_distance(points, 3, center)) <= 1e-11);
    }
  }
}

TEST_CASE("trilateration on three collinear points is refused") {
  CHECK_FALSE(trilaterate({Eigen::Vector3cd::Zero(), Eigen::Vector3cd(1, 0, 0), Eigen::Vector3cd(2, 0, 0)},
                          {1, 1, 1}));
}

TEST_CASE("the excess of a square is right to rounding where its terms are large") {
  // (L + iL, L − iL, 1): the squares of the first two cancel, 1 is left.
  const double large = 1e7;
  const Eigen::Vector3cd far(Complex(large, large), Complex(large, -large), 1);
  CHECK(squared_distance_excess(far, Eigen::Vector3cd::Zero(), {1, 0}) == Complex(0, 0));
  CHECK(squared_distance_excess(far, Eigen::Vector3cd::Zero(), {0.75, 0}) == Complex(0.25, 0));
}

TEST_CASE("a complex figure in its frame keeps its squared distances") {
  RandomNumbers numbers(2);
  const Reference reference{2, 0, 1};
  for (int i = 0; i < 100; ++i) {
    const ComplexPoints points = random_complex(numbers, 5);
    const ComplexPoints framed = in_frame(points, 3, reference);
    CHECK(framed.col(2).isZero(0));
    CHECK(framed.col(0).tail<2>().isZero(0));
    CHECK(framed(2, 1) == 0.0);
    CHECK(framed(0, 0).real() >= 0);
    CHECK(framed(1, 1).real() >= 0);
    for (int a = 0; a < 5; ++a)
      for (int b = 0; b < a; ++b)
        CHECK(std::abs(squared_distance(framed, a, b) - squared_distance(points, a, b)) <= 1e-10);
    CHECK(in_frame(framed, 3, reference) == framed);
  }
}

TEST_CASE("Newton's method finds a disturbed complex octahedron again") {
  RandomNumbers numbers(3);
  const Scene scene(samples::octahedron());
  ComplexPoints points = random_complex(numbers, 6);
  points.col(0).setZero();
  points.col(1).tail<2>().setZero();
  points(2, 2) = 0;
  std::vector<DistanceEquation> equations;
  for (const DistanceConstraint& constraint : scene.problem().constraints) {
    const auto [a, b] = constraint.between;
    equations.push_back({a, b, {0, 0}});
  }
  // Lengths are real: of a random complex figure only the real part has them.
  points.imag().setZero();
  for (DistanceEquation& e : equations) e.square = {squared_distance(points, e.a, e.b).real(), 0};
  const ComplexPoints exact = points;
  for (int p = 3; p < 6; ++p)
    points.col(p) += 1e-4 * Eigen::Vector3cd(Complex(1, -1), Complex(0, 1), Complex(1, 2));
  const ComplexRefinement refinement = refine(equations, {0, 1, 2}, points);
  CHECK(refinement.converged);
  CHECK(refinement.iterations <= 5);
  CHECK((points - exact).cwiseAbs().maxCoeff() <= 1e-12);
}

TEST_CASE(
    "points are moved to a frame in double-double as in doubles, and keep distances that doubles lose") {
  RandomNumbers numbers(5);
  const Reference reference{2, 0, 1};
  for (int i = 0; i < 100; ++i) {
    ComplexPoints points = random_complex(numbers, 5);
    const ComplexPoints framed = in_frame(points, 3, reference);
    const double size = framed.cwiseAbs().maxCoeff();
    CHECK((narrowed(in_frame(widened(points), reference)) - framed).cwiseAbs().maxCoeff() <=
          1e-13 * size * size);
    // Along an axis of square 2^-40 coordinates grow to 2^20, whose rounding to doubles moves squares by
    // 1e-4.
    points.col(2).setZero();
    points.col(0) << 1, Complex(0, 1), 0x1p-20;
    points.col(1) << 0.5 + 0x1p-20, Complex(0, 0.5), 0.7;
    const WidePoints far = in_frame(widened(points), reference);
    CHECK(narrowed(far).cwiseAbs().maxCoeff() > 1e5);
    for (int a = 0; a < 5; ++a)
      for (int b = 0; b < a; ++b)
        CHECK(std::abs(squared_distance(far, a, b) - squared_distance(points, a, b)) <= 1e-10);
  }
}

TEST_CASE("Newton's method in double-double finds distances that are lost in doubles") {
  // On a triangle of height 1/L a point (1/4, L, ±i √(L² − 0.7)) at squared distances of the order of 1.
  const double far = 0x1p12, square = 0.25 + 0x1p-24;
  const std::vector<DistanceEquation> equations{{0, 1, {1, 0}},      {0, 2, {square, 0}},
                                                {1, 2, {square, 0}}, {0, 3, {0.7625, 0}},
                                                {1, 3, {1.2625, 0}}, {2, 3, {square - 1.4875, 0}}};
  const auto largest_excess = [&](const WidePoints& points) {
    double largest = 0;
    for (const auto& [a, b, given] : equations)
      largest = std::max(largest, std::abs(squared_distance_excess(points[a], points[b], given)));
    return largest;
  };
  ComplexPoints start = ComplexPoints::Zero(3, 4);
  start(0, 1) = 1;
  start.col(2) << 0.5, 1.001 / far, 0;
  start.col(3) << 0.25, 0.999 * far, Complex(0, 1.001 * far);
  WidePoints points = widened(start);
  const ComplexRefinement refinement = refine(equations, {0, 1, 2}, points);
  CHECK(refinement.converged);
  CHECK(largest_excess(points) <= 1e-18);
  CHECK(largest_excess(widened(narrowed(points))) >= 1e-12);
  CHECK(points[3][1].value().real() == Approx(far).epsilon(1e-12));
  CHECK(points[3][2].value().imag() == Approx(std::sqrt(far * far - 0.7)).epsilon(1e-12));
}

TEST_CASE("complex figures are of one class when a complex rotation or a mirror takes one to the other") {
  RandomNumbers numbers(4);
  const Scene scene(samples::octahedron());
  const ComplexPoints points = random_complex(numbers, 6);
  ComplexPoints mirrored = in_frame(points, 3, scene.reference());
  mirrored.row(2) *= -1;
  ComplexPoints other = points;
  other(0, 5) += 1e-6;
  const std::vector<Figure> figures{complex_figure(points), complex_figure(mirrored), complex_figure(other),
                                    complex_figure(points.conjugate()), Figure{points.real(), {}, {}}};
  CHECK(reflection_classes(scene, figures, 1e-9).class_of == std::vector<int>{0, 0, 1, 2, 3});
}
