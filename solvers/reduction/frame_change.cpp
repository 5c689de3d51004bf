#include "solvers/reduction/frame_change.hpp"

#include <Eigen/LU>

#include "solvers/elements/pose_features.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

bool have_same_frame(const Scene& a, const Scene& b) {
  if (a.is_anchored()) return true;
  if (a.problem().reference_body >= 0 || b.problem().reference_body >= 0)
    return a.problem().reference_body == b.problem().reference_body;
  return a.reference().origin == b.reference().origin && a.reference().axis == b.reference().axis &&
         a.reference().plane == b.reference().plane;
}

/// Where a placement has the frame: its origin, and the images of its axes.
BodyPose frame_in(const Scene& scene, const Placement& placement) {
  const ProblemStatement& problem = scene.problem();
  if (const int body = problem.reference_body; body >= 0)
    return body_pose(
        pose_features(problem, problem.bodies[static_cast<std::size_t>(body)], -scene.unit_exponent()),
        placement, scene.dimension());
  const Reference& frame = scene.reference();
  const Eigen::Vector3cd origin = placement.points.col(frame.origin);
  const Eigen::Vector3cd x = unit_vector(placement.points.col(frame.axis) - origin);
  Eigen::Vector3cd y = cross_product(Eigen::Vector3cd::UnitZ(), x);
  if (scene.dimension() == 3) {
    const Eigen::Vector3cd to_plane = placement.points.col(frame.plane) - origin;
    y = unit_vector(to_plane - bilinear_product(to_plane, x) * x);
  }
  return {origin, triad(x, y)};
}

Placement seen_from(const BodyPose& frame, const Placement& placement) {
  const Eigen::Matrix3cd turn = frame.axes.inverse();
  Placement result = placement;
  for (Eigen::Index i = 0; i < result.points.cols(); ++i)
    result.points.col(i) = turn * (placement.points.col(i) - frame.origin);
  for (ComplexLine& line : result.lines)
    line = normalised(ComplexLine{turn * (line.point - frame.origin), turn * line.direction});
  for (ComplexPlane& plane : result.planes) {
    plane.offset -= bilinear_product(plane.normal, frame.origin);
    plane.normal = turn * plane.normal;
  }
  return result;
}

}  // namespace

FrameChange::FrameChange(const Scene& scene, const Scene& other) : scene_(scene) {
  if (!scene.problem().is_general()) {
    squares_ = target_squares(scene);
  } else if (!have_same_frame(scene, other)) {
    system_ = std::make_unique<SceneSystem>(scene);
    equations_ = general_equations(*system_);
  }
}

Figure FrameChange::operator()(const Figure& figure, bool is_simple) const {
  if (system_) return is_simple ? at_zero(moved(figure)) : moved(figure);
  if (figure.is_real() || scene_.is_anchored() || scene_.problem().is_general()) return figure;
  return polished(scene_, squares_, scene_.in_frame(figure));
}

Figure FrameChange::moved(const Figure& figure) const {
  const Placement placement = placement_of(figure);
  return figure_of(seen_from(frame_in(scene_, placement), placement), figure.is_real(),
                   system_->elements().turned_planes());
}

Figure FrameChange::at_zero(const Figure& figure) const {
  ComplexVectorX x = system_->coordinates(figure);
  return newton(equations_.system, equations_.coefficients, x) ? system_->figure(x, figure.is_real())
                                                               : figure;
}

}  // namespace gcs
