#include "solvers/construction/boundary.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Vector = Eigen::Vector3<long double>;

constexpr double root_half = 0.70710678118654752;

/// Point 3 is placed from the points 0, 1 and, in space, 2. Two spheres are circles of the plane z = 0.
Instruction instruction_of(int count) {
  Instruction instruction;
  instruction.place = 3;
  instruction.count = count;
  for (int i = 0; i < count; ++i) instruction.spheres[i] = {i, i, Eigen::Vector3d::Zero()};
  return instruction;
}

long double distance_to_line(const Vector& p, const Vector& on, const Vector& other) {
  return (p - on).cross(other - on).norm() / (other - on).norm();
}

/// Centre of the circle in which the spheres about c0 and c1 through p meet, from their radii.
Vector circle_center(const Vector& p, const Vector& c0, const Vector& c1) {
  const long double gap = (c1 - c0).norm();
  const long double r0 = (p - c0).norm();
  const long double r1 = (p - c1).norm();
  return c0 + (c1 - c0) * ((r0 * r0 - r1 * r1 + gap * gap) / (2 * gap * gap));
}

/// [I] §4.2 and §6 by their words.
long double measure_by_definition(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  std::array<Vector, 3> c;
  for (int i = 0; i < instruction.count; ++i)
    c[i] = center_of(instruction.spheres[i], points).cast<long double>();
  const Vector p = points.col(3).cast<long double>();
  if (slot == 1) return distance_to_line(p, c[0], c[1]) / std::max((p - c[0]).norm(), (p - c[1]).norm());
  const Vector center = circle_center(p, c[0], c[1]);
  const Vector normal = (c[1] - c[0]).normalized();
  const Vector projected = c[2] - normal * normal.dot(c[2] - center);
  return distance_to_line(p, center, projected) / std::max((p - center).norm(), (p - c[2]).norm());
}

/// sin of the angle at which the last two of the surfaces meet, from the normals' determinant.
long double sine_by_definition(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3<long double> n = Eigen::Matrix3<long double>::Identity();
  for (int i = 0; i < instruction.count; ++i)
    n.row(i) = (points.col(3) - center_of(instruction.spheres[i], points)).cast<long double>().normalized();
  const Vector n0 = n.row(0);
  const Vector n1 = n.row(1);
  const long double first = n0.cross(n1).norm();
  return slot == 1 ? first : std::abs(n.determinant()) / first;
}

/// The instruction after the exchange of `slot` at this figure.
Instruction shifted(Instruction instruction, int slot, const Eigen::Matrix3Xd& points) {
  instruction.spheres[slot].reference = shifted_reference(instruction, slot, points).value();
  instruction.spheres[slot].constraint = -1;
  return instruction;
}

/// Radius of the sphere or circle on which the point moves when `slot` lets go of it.
double pivot_radius(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  const Vector p = points.col(3).cast<long double>();
  const Vector c0 = center_of(instruction.spheres[0], points).cast<long double>();
  if (slot == 1) return static_cast<double>((p - c0).norm());
  const Vector c1 = center_of(instruction.spheres[1], points).cast<long double>();
  return static_cast<double>((p - circle_center(p, c0, c1)).norm());
}

/// Proposition 2, extended to what the paper leaves undefined.
void check_shift(const Instruction& before, int slot, const Eigen::Matrix3Xd& points) {
  const double a = pivot_radius(before, slot, points);
  const Instruction after = shifted(before, slot, points);
  const double gamma = static_cast<double>(measure_by_definition(after, slot, points));
  CHECK(gamma >= root_half - 1e-7);
  CHECK(gamma <= std::sqrt(0.75) + 1e-7);
  CHECK(boundary_measure(after, slot, points) == Approx(gamma).margin(1e-9));
  CHECK(crossing_sine(after, slot, points) >= std::sqrt(0.75) - 1e-7);
  const double farthest =
      (points.leftCols(before.count).colwise() - points.col(3)).colwise().norm().maxCoeff();
  CHECK((points.col(3) - after.spheres[slot].reference).norm() == Approx(a).margin(1e-14 * farthest));
}

Eigen::Vector3d direction(int dimension, RandomNumbers& random) {
  Eigen::Vector3d v;
  do v = random.point(dimension, 1);
  while (v.norm() < 0.1 || v.norm() > 1);
  return v.normalized();
}

/// Centres at distances from the placed point whose ratio is between 1 and 10^decades.
Eigen::Matrix3Xd random_configuration(int dimension, double decades, RandomNumbers& random) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(3) = random.point(dimension, 1);
  for (int i = 0; i < 3; ++i)
    points.col(i) = points.col(3) +
                    std::pow(10, random.uniform(-decades / 2, decades / 2)) * direction(dimension, random);
  return points;
}

}  // namespace

TEST_CASE("the boundary measure is that of the paper") {
  RandomNumbers random(1);
  double worst = 0;
  for (int sample = 0; sample < 3000; ++sample) {
    const int count = 2 + sample % 2;
    const Instruction instruction = instruction_of(count);
    const Eigen::Matrix3Xd points = random_configuration(count, 2, random);
    for (int slot = 1; slot < count; ++slot) {
      const double gamma = boundary_measure(instruction, slot, points);
      const double expected = static_cast<double>(measure_by_definition(instruction, slot, points));
      // Where the two centres nearly coincide the line is uncertain.
      const double gap = (points.col(1) - points.col(0)).norm();
      worst = std::max(worst, std::abs(gamma - expected) * std::min(1.0, gap));
      CHECK(gamma >= 0);
      CHECK(gamma <= 1 + 1e-15);
    }
  }
  CHECK(worst <= 1e-12);
}

TEST_CASE("the crossing sine is that of the normals") {
  RandomNumbers random(2);
  double worst = 0;
  for (int sample = 0; sample < 3000; ++sample) {
    const int count = 2 + sample % 2;
    const Instruction instruction = instruction_of(count);
    const Eigen::Matrix3Xd points = random_configuration(count, 2, random);
    const double first = static_cast<double>(sine_by_definition(instruction, 1, points));
    for (int slot = 1; slot < count; ++slot) {
      const double expected = static_cast<double>(sine_by_definition(instruction, slot, points));
      worst = std::max(worst, std::abs(crossing_sine(instruction, slot, points) - expected) * first);
    }
  }
  CHECK(worst <= 1e-12);
}

TEST_CASE("the measure vanishes at a tangency and where its line is undefined") {
  const Instruction circles = instruction_of(2);
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(0) << 1, 0, 0;
  points.col(1) << 3, 0, 0;
  CHECK(boundary_measure(circles, 1, points) == 0);
  CHECK(crossing_sine(circles, 1, points) == 0);
  points.col(1) = points.col(0);
  CHECK(boundary_measure(circles, 1, points) == 0);

  // The third centre on the axis of the circle.
  const Instruction spheres = instruction_of(3);
  points.col(0) << 0, 0, 1;
  points.col(1) << 0, 0, -2;
  points.col(2) << 0, 0, 5;
  points.col(3) << 1, 0, 0;
  CHECK(boundary_measure(spheres, 2, points) == 0);
  CHECK(crossing_sine(spheres, 2, points) <= 1e-15);
}

TEST_CASE("the sine sees centres that come together and the measure does not") {
  const Instruction circles = instruction_of(2);
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(0) << 1, 0, 0;
  points.col(1) << 1, 1e-6, 0;
  CHECK(boundary_measure(circles, 1, points) > 0.99);
  CHECK(crossing_sine(circles, 1, points) < 1.1e-6);
}

TEST_CASE("a shifted reference point is far from a boundary for any radii") {
  RandomNumbers random(3);
  for (int sample = 0; sample < 6000; ++sample) {
    const int count = 2 + sample % 2;
    const Instruction instruction = instruction_of(count);
    const Eigen::Matrix3Xd points = random_configuration(count, 6, random);
    CAPTURE(sample, points);
    check_shift(instruction, 1, points);
    // interCS is looked at only when its circle is well determined.
    if (count == 3 && sine_by_definition(instruction, 1, points) > 1e-2) check_shift(instruction, 2, points);
  }
}

TEST_CASE("in the paper's direction the measure becomes 1/2 + v/(2a), squared") {
  RandomNumbers random(4);
  for (int sample = 0; sample < 3000; ++sample) {
    const int dimension = 2 + sample % 2;
    const Instruction instruction = instruction_of(dimension);
    Eigen::Matrix3Xd points = random_configuration(dimension, 0, random);
    const double a = std::pow(10, random.uniform(-3, 3));
    // p at the height v above the line through the centres
    const double v = a * std::pow(10, random.uniform(-6, std::log10(0.4999)));
    const Eigen::Vector3d along = direction(dimension, random);
    Eigen::Vector3d up = random.point(dimension, 1);
    up = (up - along * along.dot(up)).normalized();
    points.col(3) = random.point(dimension, a);
    const double foot = random.sign() * std::sqrt((a - v) * (a + v));
    points.col(0) = points.col(3) - v * up - foot * along;
    points.col(1) = points.col(0) + random.sign() * a * random.uniform(0.1, 10) * along;
    const Instruction after = shifted(instruction, 1, points);
    const auto gamma = static_cast<double>(measure_by_definition(after, 1, points));
    CAPTURE(sample, v / a);
    CHECK(gamma * gamma == Approx(0.5 + v / (2 * a)).margin(1e-8));
    const Eigen::Vector3d expected = points.col(3) - a * up;
    CHECK((after.spheres[1].reference - expected).norm() <= 1e-8 * a);
  }
}

TEST_CASE("a shift works at the boundary itself and where the paper's direction is undefined") {
  RandomNumbers random(5);
  for (int sample = 0; sample < 2000; ++sample) {
    const int dimension = 2 + sample % 2;
    const Instruction spheres = instruction_of(dimension);
    Eigen::Matrix3Xd points = random_configuration(dimension, 2, random);
    const Eigen::Vector3d arm = points.col(3) - points.col(0);
    CAPTURE(sample);
    // p on the line of the centres: v = 0, or v tiny
    points.col(1) = points.col(0) + random.sign() * random.uniform(0.1, 4) * arm;
    check_shift(spheres, 1, points);
    points.col(1) += std::pow(10, random.uniform(-16, -6)) * random.point(dimension, 1);
    check_shift(spheres, 1, points);
    points.col(1) = points.col(0);
    check_shift(spheres, 1, points);
    // p above the centre: the paper's direction is the centre's, where the circles would touch.
    const Eigen::Vector3d across =
        dimension == 2 ? Eigen::Vector3d(-arm.y(), arm.x(), 0) : Eigen::Vector3d(arm.unitOrthogonal());
    points.col(1) = points.col(0) + across;
    check_shift(spheres, 1, points);
  }
}

TEST_CASE("a shift of interCS works where its line is undefined or meets the point") {
  RandomNumbers random(6);
  for (int sample = 0; sample < 2000; ++sample) {
    const Instruction spheres = instruction_of(3);
    Eigen::Matrix3Xd points = random_configuration(3, 0.5, random);
    if (sine_by_definition(spheres, 1, points) < 0.1) continue;
    const Vector center = circle_center(points.col(3).cast<long double>(), points.col(0).cast<long double>(),
                                        points.col(1).cast<long double>());
    const Eigen::Vector3d axis = (points.col(1) - points.col(0)).normalized();
    const Eigen::Vector3d middle = center.cast<double>();
    const Eigen::Vector3d arm = points.col(3) - middle;
    CAPTURE(sample);
    points.col(2) = middle + random.uniform(-3, 3) * axis;
    check_shift(spheres, 2, points);
    points.col(2) = middle + random.uniform(-3, 3) * axis + random.uniform(-3, 3) * arm;
    check_shift(spheres, 2, points);
    points.col(2) = middle + random.uniform(-3, 3) * axis + random.uniform(0.1, 3) * axis.cross(arm);
    check_shift(spheres, 2, points);
  }
}

TEST_CASE("the printed shift of interCS would leave the measure below the threshold") {
  // r = 1 and a_i6 = 12: the reference point at the larger of the two, as printed.
  const Instruction spheres = instruction_of(3);
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(0) << 0, 0, 2;
  points.col(1) << 0, 0, -2;
  points.col(2) << 0.9, 0, std::sqrt(144 - 0.01);
  points.col(3) << std::sqrt(1 - 1e-4), 1e-2, 0;
  Instruction printed = spheres;
  printed.spheres[2].constraint = -1;
  printed.spheres[2].reference = points.col(3) + 12 * Eigen::Vector3d(0, -1, 0);
  CHECK(boundary_measure(printed, 2, points) == Approx(0.083).margin(1e-3));
  check_shift(spheres, 2, points);
}

TEST_CASE("the printed shift to the larger radius leaves the measure at 1/√(1 + (a/r)²)") {
  const Instruction spheres = instruction_of(3);
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 4);
  points.col(0) << 0, 0, 1;
  points.col(1) << 0, 0, -2;
  points.col(2) << 13, 0, 0;  // a_i6 = 12, nearly in line with the circle's centre
  points.col(3) << std::cos(1e-6), std::sin(1e-6), 0;
  const auto after = [&](bool larger_radius) {
    Instruction instruction = spheres;
    instruction.spheres[2].reference = shifted_reference(spheres, 2, points, {larger_radius, true}).value();
    instruction.spheres[2].constraint = -1;
    return boundary_measure(instruction, 2, points);
  };
  CHECK(after(true) == Approx(1 / std::sqrt(145)).epsilon(1e-5));
  CHECK(after(false) == Approx(root_half).epsilon(1e-5));
}

TEST_CASE("the printed shift goes towards the projection at any angle, and nowhere without one") {
  RandomNumbers random(6);
  for (int sample = 0; sample < 500; ++sample) {
    const int dimension = 2 + sample % 2;
    const Instruction instruction = instruction_of(dimension);
    const Eigen::Matrix3Xd points = random_configuration(dimension, 1, random);
    const Eigen::Vector3d p = points.col(3), along = points.col(1) - points.col(0), arm = p - points.col(0);
    const Eigen::Vector3d to_foot = along * (arm.dot(along) / along.squaredNorm()) - arm;
    const auto reference = shifted_reference(instruction, 1, points, {false, true});
    REQUIRE(reference);
    CHECK((*reference - p - arm.norm() * to_foot.normalized()).norm() <= 1e-10 * arm.norm());
  }
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, 4);
  flat.row(0) << 1, 3, 0, 2;
  CHECK_FALSE(shifted_reference(instruction_of(2), 1, flat, {false, true}));
  CHECK(shifted_reference(instruction_of(2), 1, flat));
}
