#include "solvers/pyramid/pyramid_branches.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gcs {

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
  const Places fourths = places(3, p1, pyramid_.spoke[0], fourth_);
  if (fourths.count == 0) return;
  for (const Eigen::Vector3d& p2 : places(1, p1, pyramid_.spoke[0], second_))
    for (const Eigen::Vector3d& p3 : places(2, p2, pyramid_.spoke[1], third_))
      for (const Eigen::Vector3d& p4 : fourths) branches.push_back({{p1, p2, p3, p4}});
}

Places PyramidBranches::places(int point, const Eigen::Vector3d& hinge, double hinge_length,
                               const std::optional<HingeCircle>& circle) const {
  return meet_cylinder(apex_, (hinge - apex_) / hinge_length, *circle, pyramid_.radius[point]);
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
