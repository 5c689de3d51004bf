/// Points by their height near a branch end, against points computed at single angles.

#include "solvers/scanning/height_placing.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Form = AffineForm<1>;
using Vector = Eigen::Vector3d;

FormVector<1> moving(const Vector& middle, const Vector& slope) {
  FormVector<1> form;
  for (int axis = 0; axis < 3; ++axis) {
    form[axis].mid = middle[axis];
    form[axis].slope[0] = slope[axis];
  }
  return form;
}

Vector at(const FormVector<1>& form, double xi) {
  Vector value;
  for (int axis = 0; axis < 3; ++axis) value[axis] = form[axis].mid + form[axis].slope[0] * xi;
  return value;
}

Vector random_vector(RandomNumbers& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Two spheres and a third or a plane, whose centre or normal moves, such that they touch at one point when the symbol is 0.
struct TouchingSurfaces {
  std::array<FormSurface<1>, 3> surfaces;
  Vector touched;

  TouchingSurfaces(RandomNumbers& random, double reach, bool with_plane) {
    touched = random_vector(random, 1);
    const Vector u = random_vector(random, 1), v = random_vector(random, 1);
    const double along_u = random.uniform(-1, 1), along_v = random.uniform(-1, 1);
    const std::array<Vector, 3> ways{u, v, along_u * u + along_v * v};
    const Vector slope = random_vector(random, reach);
    for (std::size_t i = 0; i < 3; ++i)
      surfaces[i] = {moving(touched - ways[i], i == 2 ? slope : Vector::Zero()), Form(ways[i].squaredNorm())};
    if (with_plane) surfaces[2] = {moving(ways[2], slope), Form(ways[2].dot(touched)), true};
  }

  Vector center() const { return at(surfaces[0].vector, 0); }
  /// Of the plane of all points that surface 0 and another one may have in common.
  Vector common_normal(std::size_t i, double xi) const {
    const Vector vector = at(surfaces[i].vector, xi);
    return surfaces[i].is_plane ? vector : vector - center();
  }
  Vector normal(double xi) const { return common_normal(1, xi).cross(common_normal(2, xi)); }

  /// The point above the plane of these normals, or nothing.
  std::optional<Vector> above(double xi) const {
    Eigen::Matrix3d rows;
    Vector right;
    for (int i = 1; i < 3; ++i) {
      const FormSurface<1>& surface = surfaces[static_cast<std::size_t>(i)];
      const Vector way = common_normal(static_cast<std::size_t>(i), xi);
      rows.row(i) = way;
      right[i] = surface.is_plane ? surface.number.mid - way.dot(center())
                                  : (surfaces[0].number.mid - surface.number.mid + way.squaredNorm()) / 2;
    }
    rows.row(0) = normal(xi);
    right[0] = 0;
    const Vector foot = rows.partialPivLu().solve(right);
    const double square = surfaces[0].number.mid - foot.squaredNorm();
    if (square < 0) return std::nullopt;
    return center() + foot + std::sqrt(square) * normal(xi).normalized();
  }
};

/// From all that a symbol can be and a box around the point of contact.
PointByHeight<1> rough(const TouchingSurfaces& surfaces, double width) {
  PointByHeight<1> known;
  known.exchange.symbol = 0;
  known.exchange.value.rest = 1;
  for (int axis = 0; axis < 3; ++axis) {
    known.position[axis].mid = surfaces.touched[axis];
    known.position[axis].rest = width;
  }
  return known;
}

FormVector<1> normal_form(const TouchingSurfaces& touching) {
  const auto& surfaces = touching.surfaces;
  return cross(common_normal(surfaces[0], surfaces[1]), common_normal(surfaces[0], surfaces[2]));
}

/// Heights from 0 to `top`.
Form heights_to(double top) {
  Form sigma(top / 2);
  sigma.slope[0] = top / 2;
  sigma.rest = 4 * Form::epsilon * top;
  return sigma;
}

}  // namespace

TEST_CASE("a point by its height holds every point of the branch down to its end") {
  RandomNumbers random(11);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const double reach = std::exp2(-random.uniform(8, 30));
    const TouchingSurfaces surfaces(random, reach, i % 2 == 1);
    if (surfaces.normal(0).norm() < 0.1) continue;
    double top = 0;
    double width = 0;
    for (int j = -64; j <= 64; ++j) {
      const auto point = surfaces.above(j / 64.0);
      if (!point) continue;
      top = std::max(top, surfaces.normal(j / 64.0).dot(*point - surfaces.center()));
      width = std::max(width, (*point - surfaces.touched).cwiseAbs().maxCoeff());
    }
    if (top == 0) continue;
    const HeightPlacing<3, 1> placing(surfaces.surfaces);
    const PointByHeight<1> sharp =
        placing.sharpened(rough(surfaces, 1.1 * width), normal_form(surfaces), heights_to(top));
    for (int j = -64; j <= 64; ++j) {
      const double xi = j / 64.0;
      const auto point = surfaces.above(xi);
      if (!point) continue;
      const double eta = 2 * surfaces.normal(xi).dot(*point - surfaces.center()) / top - 1;
      // The height of the computed point has the root of the rounding of its square: 1e-16 / height.
      const double noise = 1e-14 / std::max(1e-7, (eta + 1) * top);
      const double off = (*point - at(sharp.position, eta)).cwiseAbs().maxCoeff();
      const Form& value = sharp.exchange.value;
      REQUIRE(off <= unknown_of(sharp.position) + noise);
      REQUIRE(std::abs(xi - value.mid - value.slope[0] * eta) <= value.rest + noise / reach);
      ++compared;
    }
  }
  CHECK(compared > 5000);
}

TEST_CASE("what is unknown of a point by its height falls with the square of the height") {
  for (const bool with_plane : {false, true}) {
    RandomNumbers random(12);
    const TouchingSurfaces surfaces(random, 1e-3, with_plane);
    double before = 0;
    for (const double top : {1e-3, 1e-4, 1e-5}) {
      const HeightPlacing<3, 1> placing(surfaces.surfaces);
      const PointByHeight<1> sharp =
          placing.sharpened(rough(surfaces, 10 * top), normal_form(surfaces), heights_to(top));
      const double unknown = unknown_of(sharp.position);
      CHECK(moved_by(0, sharp.position) > 0.1 * top);
      if (before > 0) CHECK(unknown < 0.03 * before);
      before = unknown;
    }
  }
}
