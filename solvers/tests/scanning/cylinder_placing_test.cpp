/// Sharpened points on two spheres and a cylinder, against points computed at single angles.

#include "solvers/scanning/cylinder_placing.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Form = AffineForm<1>;
using Vector = Eigen::Vector3d;

/// A point on spheres around two centres and on a cylinder around the x-axis; the second centre moves.
struct MovingPoint {
  Vector start, first, second, slope;

  MovingPoint(RandomNumbers& random, double reach)
      : start(random.point(3, 1)),
        first(random.point(3, 1)),
        second(random.point(3, 1)),
        slope(random.point(3, reach)) {}

  Eigen::Matrix3d jacobian(const Vector& p, double xi) const {
    Eigen::Matrix3d rows;
    rows.row(0) = p - first;
    rows.row(1) = p - second - xi * slope;
    rows.row(2) = Vector(0, p.y(), p.z());
    return 2 * rows;
  }

  /// By Newton's method from where it is at 0.
  Vector at(double xi) const {
    Vector p = start;
    for (int i = 0; i < 20; ++i) {
      const Vector excess((p - first).squaredNorm() - (start - first).squaredNorm(),
                          (p - second - xi * slope).squaredNorm() - (start - second).squaredNorm(),
                          p.tail<2>().squaredNorm() - start.tail<2>().squaredNorm());
      p -= jacobian(p, xi).partialPivLu().solve(excess);
    }
    return p;
  }

  FormVector<1> sharpened(double width) const {
    FormVector<1> known = constant_form<1>(start);
    for (Form& x : known) x.rest = width;
    FormVector<1> moving = constant_form<1>(second);
    for (int axis = 0; axis < 3; ++axis) moving[axis].slope[0] = slope[axis];
    return sharpened_on_cylinder<1>(
        known,
        {FormSurface<1>{constant_form<1>(first), square(constant_form<1>(start - first))},
         FormSurface<1>{moving, square(constant_form<1>(start - second))}},
        square(Form(start.y())) + square(Form(start.z())));
  }
};

}  // namespace

TEST_CASE("a sharpened point on a cylinder holds the point at every angle") {
  RandomNumbers random(21);
  int sharpened = 0;
  for (int i = 0; i < repetitions(300); ++i) {
    const MovingPoint point(random, std::exp2(-random.uniform(8, 30)));
    if (std::abs(point.jacobian(point.start, 0).determinant()) < 0.5) continue;
    double width = 0;
    for (int j = -8; j <= 8; ++j)
      width = std::max(width, (point.at(j / 8.0) - point.start).cwiseAbs().maxCoeff());
    const FormVector<1> form = point.sharpened(1.1 * width);
    if (unknown_of(form) < 0.3 * width) ++sharpened;
    for (int j = -8; j <= 8; ++j)
      for (int axis = 0; axis < 3; ++axis) {
        const double linear = form[axis].mid + form[axis].slope[0] * j / 8.0;
        // 1e-14: of Newton's method in double at lengths near 1 and a condition near 10.
        REQUIRE(std::abs(point.at(j / 8.0)[axis] - linear) <= form[axis].rest + 1e-14);
      }
  }
  CHECK(sharpened > repetitions(100));
}

TEST_CASE("where the equations are singular a point on a cylinder stays as it was known") {
  RandomNumbers random(22);
  MovingPoint point(random, 1e-3);
  point.second = point.first;
  point.slope.setZero();
  CHECK(unknown_of(point.sharpened(1e-2)) == 3e-2);
}
