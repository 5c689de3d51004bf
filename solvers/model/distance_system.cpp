#include "solvers/model/distance_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/model/frame_choice.hpp"
#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

Reference frame_of(const Scene& scene) {
  const bool puts_line = !scene.has_lines() || scene.reference().line >= 0;
  return puts_line ? scene.reference() : line_reference(scene.problem());
}

bool fixed_by_frame(const Scene& scene, const Reference& reference, int point, int axis) {
  if (scene.fixed_point(point)) return true;
  if (scene.is_anchored()) return false;
  if (reference.line >= 0) return point == reference.height && axis < 2;
  if (point == reference.origin) return true;
  if (point == reference.axis) return axis > 0;
  return point == reference.plane && axis > 1;
}

}  // namespace

DistanceSystem::DistanceSystem(const Scene& scene) : DistanceSystem(scene, frame_of(scene)) {}

DistanceSystem::DistanceSystem(const Scene& scene, const Reference& reference)
    : reference_(reference),
      dimension_(scene.dimension()),
      point_count_(scene.point_count()),
      has_line_(scene.has_lines()),
      unknown_(3 * (static_cast<std::size_t>(scene.point_count()) + scene.problem().lines.size()), -1),
      fixed_coordinates_(Eigen::Matrix3Xd::Zero(3, scene.point_count())),
      coordinate_errors_(Eigen::Matrix3Xd::Zero(3, scene.point_count())) {
  for (const DistanceConstraint& c : scene.problem().constraints) {
    edges_.push_back(c.between);
    if (!scene.problem().is_point(c.between[0])) std::swap(edges_.back()[0], edges_.back()[1]);
  }
  for (int point = 0; point < point_count_; ++point) {
    if (const auto position = scene.fixed_point(point)) fixed_coordinates_.col(point) = *position;
    for (int axis = 0; axis < dimension_; ++axis) {
      coordinate_errors_(axis, point) = gcs::coordinate_error(scene, point, axis);
      if (!fixed_by_frame(scene, reference_, point, axis)) unknown_[3 * point + axis] = unknowns_++;
    }
  }
}

Eigen::VectorXd DistanceSystem::coordinates(const Figure& figure) const {
  Eigen::VectorXd x(unknowns_);
  for (int i = 0; i < 3 * point_count_; ++i)
    if (unknown_[i] >= 0) x[unknown_[i]] = figure.points.data()[i];
  return x;
}

Figure DistanceSystem::figure(const Eigen::Ref<const Eigen::VectorXd>& x) const {
  Figure figure;
  figure.points = fixed_coordinates_;
  if (has_line_) figure.lines = {LinePosition{}};
  place(x, figure.points);
  return figure;
}

void DistanceSystem::place(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Matrix3Xd& points) const {
  for (int i = 0; i < 3 * point_count_; ++i)
    if (unknown_[i] >= 0) points.data()[i] = x[unknown_[i]];
}

/// The two points whose distance is that of edge `e`: the second of a line is the foot on it.
std::array<Eigen::Vector3d, 2> DistanceSystem::ends(const Eigen::Matrix3Xd& points, int e) const {
  const auto [a, b] = edges_[e];
  if (!is_line(b)) return {points.col(a), points.col(b)};
  return {points.col(a), Eigen::Vector3d(points(0, a), 0, 0)};
}

DoubleDouble DistanceSystem::squared_length(const Eigen::Matrix3Xd& points, int e) const {
  const auto [p, q] = ends(points, e);
  return squared_distance(p, q, dimension_);
}

void DistanceSystem::residual(const Eigen::Matrix3Xd& points, const std::vector<DoubleDouble>& squares,
                              Eigen::Ref<Eigen::VectorXd> f) const {
  for (int e = 0; e < equations(); ++e)
    f[e] = (squared_length(points, e) - squares[static_cast<std::size_t>(e)]).value() / 2;
}

void DistanceSystem::jacobian(const Eigen::Matrix3Xd& points, Eigen::Ref<Eigen::MatrixXd> jacobian) const {
  jacobian.leftCols(unknowns_).setZero();
  for (int e = 0; e < equations(); ++e) {
    const auto [a, b] = edges_[e];
    const auto [p, q] = ends(points, e);
    for (int axis = 0; axis < dimension_; ++axis) {
      const double difference = p[axis] - q[axis];
      if (unknown(a, axis) >= 0) jacobian(e, unknown(a, axis)) = difference;
      if (unknown(b, axis) >= 0) jacobian(e, unknown(b, axis)) = -difference;
    }
  }
}

std::vector<DoubleDouble> target_squares(const Scene& scene) {
  std::vector<DoubleDouble> squares;
  for (int i = 0; i < scene.constraint_count(); ++i)
    squares.push_back(nearest_double_double(given_square(scene, i)));
  return squares;
}

Refinement refine(const DistanceSystem& system, const std::vector<DoubleDouble>& squares,
                  Eigen::VectorXd& x) {
  constexpr int max_iterations = 12;
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  // Factors are kept where the last correction was small beside the coordinates, and at most this part of the one before.
  constexpr double small = 1e-6, good = 1e-3;
  const int m = system.equations();
  const Eigen::VectorXd start = x;
  Eigen::MatrixXd jacobian(m, system.unknowns());
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
  Eigen::VectorXd residual(m);
  Figure figure = system.figure(x);
  Refinement result;
  double previous = std::numeric_limits<double>::infinity();
  for (bool are_good = false; result.iterations < max_iterations;) {
    system.place(x, figure.points);
    system.residual(figure.points, squares, residual);
    const bool are_new = !are_good;
    if (are_new) {
      system.jacobian(figure.points, jacobian);
      factors.compute(jacobian);
    }
    const Eigen::VectorXd correction = factors.solve(residual);
    x -= correction;
    ++result.iterations;
    result.last_correction = correction.norm();
    if (!std::isfinite(result.last_correction)) break;
    const double size = x.cwiseAbs().maxCoeff();
    result.converged = result.last_correction <= 4 * ulp * size;
    if (result.converged || (are_new && result.last_correction > previous / 2)) break;
    are_good = result.last_correction <= std::min(small * size, good * previous);
    previous = result.last_correction;
  }
  // Rounding keeps an ill-conditioned solution from settling to the last bit; the size of its last correction
  // says how far.
  constexpr double settled = 1e-6;
  result.converged = result.converged || result.last_correction <= settled * x.cwiseAbs().maxCoeff();
  if (!result.converged) x = start;
  return result;
}

std::vector<int> mirror_axes(const Scene& scene, const DistanceSystem& system) {
  std::vector<int> axes(static_cast<std::size_t>(system.unknowns()), -1);
  if (scene.is_anchored()) return axes;
  for (int point = 0; point < system.point_count(); ++point)
    for (int axis = 0; axis < system.dimension(); ++axis)
      if (const int unknown = system.unknown(point, axis); unknown >= 0) axes[unknown] = axis;
  return axes;
}

}  // namespace gcs
