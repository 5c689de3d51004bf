#include "solvers/pyramid/pyramid_branches.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solvers/numeric/trigonometric_roots.hpp"

namespace gcs {
namespace {

/// The circle of the points at distance `a` from the apex and `b` from a point at distance `base` from it.
/// Nothing where the three are no triangle. h is the height over the base by Heron's formula, whose factors
/// lose no digits where the triangle is flat.
std::optional<HingeCircle> hinge_circle(double a, double b, double base) {
  const double product = (b - (base - a)) * (b + (base - a)) * ((base + a) - b) * ((base + a) + b);
  if (product < 0) return std::nullopt;
  return HingeCircle{(base * base + (a - b) * (a + b)) / (2 * base), std::sqrt(product) / (2 * base)};
}

/// y² + z² − r² on the circle center + u·cos φ + v·sin φ.
TwoHarmonics outside_cylinder(const Eigen::Vector3d& center, const Eigen::Vector3d& u,
                              const Eigen::Vector3d& v, double r) {
  const Eigen::Vector2d c = center.tail<2>(), p = u.tail<2>(), q = v.tail<2>();
  TwoHarmonics f;
  f.constant = c.squaredNorm() + (p.squaredNorm() + q.squaredNorm()) / 2 - r * r;
  f.cos1 = 2 * c.dot(p);
  f.sin1 = 2 * c.dot(q);
  f.cos2 = (p - q).dot(p + q) / 2;
  f.sin2 = p.dot(q);
  return f;
}

}  // namespace

PyramidBranches::PyramidBranches(const Pyramid& pyramid)
    : pyramid_(pyramid),
      apex_(0, 0, pyramid.apex_radius),
      second_(hinge_circle(pyramid.spoke[1], pyramid.side[0], pyramid.spoke[0])),
      third_(hinge_circle(pyramid.spoke[2], pyramid.side[1], pyramid.spoke[1])),
      fourth_(hinge_circle(pyramid.spoke[3], pyramid.side[3], pyramid.spoke[0])) {}

std::vector<PyramidBranch> PyramidBranches::at(double theta) const {
  const double y = pyramid_.radius[0] * std::cos(theta);
  const double z = pyramid_.radius[0] * std::sin(theta);
  const double across = std::hypot(y, z - pyramid_.apex_radius);
  const double square = (pyramid_.spoke[0] - across) * (pyramid_.spoke[0] + across);
  std::vector<PyramidBranch> branches;
  if (!second_ || !third_ || !fourth_ || square < 0) return branches;
  const double x = std::sqrt(square);
  append({x, y, z}, branches);
  if (x > 0) append({-x, y, z}, branches);
  return branches;
}

void PyramidBranches::append(const Eigen::Vector3d& p1, std::vector<PyramidBranch>& branches) const {
  const std::vector<Eigen::Vector3d> fourths = places(3, p1, pyramid_.spoke[0], fourth_);
  if (fourths.empty()) return;
  for (const Eigen::Vector3d& p2 : places(1, p1, pyramid_.spoke[0], second_))
    for (const Eigen::Vector3d& p3 : places(2, p2, pyramid_.spoke[1], third_))
      for (const Eigen::Vector3d& p4 : fourths) branches.push_back({{p1, p2, p3, p4}});
}

/// The points of the circle around the axis from the apex to `hinge` that lie on the cylinder of
/// cycle[point].
std::vector<Eigen::Vector3d> PyramidBranches::places(int point, const Eigen::Vector3d& hinge,
                                                     double hinge_length,
                                                     const std::optional<HingeCircle>& circle) const {
  const Eigen::Vector3d axis = (hinge - apex_) / hinge_length;
  const Eigen::Vector3d center = apex_ + circle->offset * axis;
  const Eigen::Vector3d u = circle->radius * axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  std::vector<Eigen::Vector3d> result;
  for (const double angle : real_zeros(outside_cylinder(center, u, v, pyramid_.radius[point])))
    result.emplace_back(center + std::cos(angle) * u + std::sin(angle) * v);
  return result;
}

Figure figure_of(const Pyramid& pyramid, const PyramidBranch& branch) {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 5);
  figure.points(2, pyramid.apex) = pyramid.apex_radius;
  for (std::size_t i = 0; i < 4; ++i) figure.points.col(pyramid.cycle[i]) = branch.cycle[i];
  figure.lines = {LinePosition{}};
  return figure;
}

std::vector<GapSample> sample_gap_curve(const Pyramid& pyramid, int count) {
  const PyramidBranches branches(pyramid);
  std::vector<GapSample> samples;
  for (int i = 0; i < count; ++i) {
    const double degrees = 360.0 * i / count;
    for (const PyramidBranch& branch : branches.at(degrees * std::numbers::pi / 180))
      samples.push_back({degrees, branch.gap()});
  }
  return samples;
}

}  // namespace gcs
