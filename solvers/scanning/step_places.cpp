#include "solvers/scanning/step_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solvers/numeric/trigonometric_roots.hpp"

namespace gcs {
namespace {

using Point = Eigen::Vector3d;

/// y² + z² − r² on the circle center + u·cos φ + v·sin φ.
TwoHarmonics outside_cylinder(const Point& center, const Point& u, const Point& v, double r) {
  const Eigen::Vector2d c = center.tail<2>(), p = u.tail<2>(), q = v.tail<2>();
  TwoHarmonics f;
  f.constant = c.squaredNorm() + (p.squaredNorm() + q.squaredNorm()) / 2 - r * r;
  f.cos1 = 2 * c.dot(p);
  f.sin1 = 2 * c.dot(q);
  f.cos2 = (p - q).dot(p + q) / 2;
  f.sin2 = p.dot(q);
  return f;
}

TwoHarmonics derivative(const TwoHarmonics& f) {
  TwoHarmonics slope;
  slope.cos1 = f.sin1;
  slope.sin1 = -f.cos1;
  slope.cos2 = 2 * f.sin2;
  slope.sin2 = -2 * f.cos2;
  return slope;
}

/// center + u·cos φ + v·sin φ
struct CirclePoints {
  CirclePoints(const Point& origin, const Point& axis, const HingeCircle& circle)
      : center(origin + circle.offset * axis), u(circle.radius * axis.unitOrthogonal()), v(axis.cross(u)) {}

  template <class Angles>
  Places at(const Angles& angles) const {
    Places places;
    for (const double angle : angles) places.append(center + std::cos(angle) * u + std::sin(angle) * v);
    return places;
  }

  Point center, u, v;
};

/// The length that a constraint gives between two points, the same in every placing.
std::optional<double> given_length(const Scene& scene, int a, int b) {
  const auto& constraints = scene.problem().constraints;
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const auto& between = constraints[c].between;
    if ((between[0] == a && between[1] == b) || (between[0] == b && between[1] == a))
      return scene.target_lengths()[c];
  }
  return std::nullopt;
}

/// Both ways from `foot`, or the upper one; one where they are the same.
Places both_sides(const Point& foot, const Point& offset, bool only_upper) {
  Places places;
  places.append(foot + offset);
  if (!only_upper && !offset.isZero(0)) places.append(foot - offset);
  return places;
}

}  // namespace

std::optional<HingeCircle> hinge_circle(double a, double b, double base) {
  const double product = (b - (base - a)) * (b + (base - a)) * ((base + a) - b) * ((base + a) + b);
  if (!(base > 0) || product < 0) return std::nullopt;
  return HingeCircle{(base * base + (a - b) * (a + b)) / (2 * base), std::sqrt(product) / (2 * base)};
}

Places meet_cylinder(const Point& origin, const Point& axis, const HingeCircle& circle, double around_line) {
  const CirclePoints points(origin, axis, circle);
  return points.at(real_zeros(outside_cylinder(points.center, points.u, points.v, around_line)));
}

Places extreme_distances_from_x_axis(const Point& origin, const Point& axis, const HingeCircle& circle) {
  const CirclePoints points(origin, axis, circle);
  return points.at(real_zeros(derivative(outside_cylinder(points.center, points.u, points.v, 0))));
}

StepPlaces::StepPlaces(const Scene& scene, const ScanPlan& plan) : scene_(scene), plan_(plan) {
  for (const ScanStep& step : plan.steps)
    given_bases_.push_back(step.spheres.size() < 2
                               ? std::nullopt
                               : given_length(scene, step.spheres[0].center, step.spheres[1].center));
}

Places StepPlaces::of(std::size_t k, const Eigen::Matrix3Xd& points,
                      const std::array<double, 2>& angles) const {
  const ScanStep& step = plan_.steps[k];
  if (step.cylinder >= 0) return around_line(k, points, angles[0]);
  if (step.freedom > 1 && step.angles() == 0) return on_two_sides(k, points);
  if (step.freedom == 3 && step.angles() == 1) return on_circle(k, points, angles[0]);
  return around_one(step, points, angles);
}

std::optional<StepPlaces::Hinge> StepPlaces::hinge(std::size_t k, const Eigen::Matrix3Xd& points) const {
  const ScanSphere& a = plan_.steps[k].spheres[0];
  const ScanSphere& b = plan_.steps[k].spheres[1];
  const Point way = points.col(b.center) - points.col(a.center);
  const double gap = given_bases_[k].value_or(way.norm());
  const auto circle = hinge_circle(length(a.constraint), length(b.constraint), gap);
  if (!circle) return std::nullopt;
  return Hinge{points.col(a.center), way / gap, *circle};
}

/// The point of the frame at the line's height; on a sphere at an angle around the line; or on a circle.
Places StepPlaces::around_line(std::size_t k, const Eigen::Matrix3Xd& points, double angle) const {
  const ScanStep& step = plan_.steps[k];
  const double radius = length(step.cylinder);
  Places places;
  if (step.freedom == 1) {
    places.append({0, 0, radius});
  } else if (step.angles() == 1) {
    const Point center = points.col(step.spheres[0].center);
    const double spoke = length(step.spheres[0].constraint);
    const Point foot(center[0], radius * std::cos(angle), radius * std::sin(angle));
    const double across = std::hypot(foot[1] - center[1], foot[2] - center[2]);
    const double square = (spoke - across) * (spoke + across);
    if (square >= 0) return both_sides(foot, {std::sqrt(square), 0, 0}, step.upper);
  } else if (const auto two = hinge(k, points)) {
    return meet_cylinder(two->origin, two->axis, two->circle, radius);
  }
  return places;
}

/// A point of the frame, or one at any angles around another.
Places StepPlaces::around_one(const ScanStep& step, const Eigen::Matrix3Xd& points,
                              const std::array<double, 2>& angles) const {
  Places places;
  if (step.freedom == 0) {
    places.append(Point::Zero());
    return places;
  }
  const double radius = length(step.spheres[0].constraint);
  const double c = std::cos(angles[0]), s = std::sin(angles[0]);
  const Point center = points.col(step.spheres[0].center);
  if (step.freedom == 1) {
    places.append({radius, 0, 0});
  } else if (step.angles() == 1) {
    places.append(center + radius * Point(c, s, 0));
  } else {
    const double level = std::cos(angles[1]), height = std::sin(angles[1]);
    places.append(center + radius * Point(level * c, level * s, height));
  }
  return places;
}

Places StepPlaces::on_circle(std::size_t k, const Eigen::Matrix3Xd& points, double angle) const {
  const auto two = hinge(k, points);
  if (!two) return {};
  // The same direction as step_pieces.hpp takes for a right angle.
  const Point up = plan_.steps[k].upper ? Point(0, 0, 1) : Point(0.36, 0.48, 0.8);
  const Point second = up - up.dot(two->axis) * two->axis;
  if (second.isZero(0)) return {};
  const Point second_unit = second.normalized();
  const Point first = second_unit.cross(two->axis);
  Places places;
  places.append(two->center() +
                two->circle.radius * (std::cos(angle) * first + std::sin(angle) * second_unit));
  return places;
}

/// Circles in the plane meet on both sides of the line of their centres; a third sphere meets the circle of
/// two on both sides of the plane of the centres, which are found in the circle's plane in the same way.
Places StepPlaces::on_two_sides(std::size_t k, const Eigen::Matrix3Xd& points) const {
  const ScanStep& step = plan_.steps[k];
  const auto two = hinge(k, points);
  if (!two) return {};
  if (step.freedom == 2)
    return both_sides(two->center(), two->circle.radius * Point(-two->axis[1], two->axis[0], 0), step.upper);
  const Point way = points.col(step.spheres[2].center) - two->center();
  const double off = way.dot(two->axis), reach = length(step.spheres[2].constraint);
  const double section = (reach - off) * (reach + off);
  const Point within = way - off * two->axis;
  const double gap = within.norm();
  if (section < 0) return {};
  const auto meeting = hinge_circle(two->circle.radius, std::sqrt(section), gap);
  if (!meeting) return {};
  const Point unit = within / gap;
  return both_sides(two->center() + meeting->offset * unit, meeting->radius * two->axis.cross(unit),
                    step.upper);
}

}  // namespace gcs
