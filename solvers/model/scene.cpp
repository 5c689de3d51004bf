#include "solvers/model/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solvers/model/bend_defect.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/figure_in_frame.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/structure/structure.hpp"

namespace gcs {
namespace {

/// The largest coordinate of a fixed position that distances are measured from; where positions leave motions, from the
/// frame that is put in them.
double fixed_extent(const ProblemStatement& problem) {
  double extent = 0;
  const Eigen::Vector3d origin = problem.file_frame ? problem.file_frame->origin : Eigen::Vector3d::Zero();
  for (const DistanceConstraint& constraint : problem.constraints)
    for (const int end : constraint.between)
      if (problem.is_point(end) && problem.is_fixed(end))
        extent = std::max(extent, (*problem.fixed_points[end] - origin).cwiseAbs().maxCoeff());
  for (const auto& point : problem.fixed_points)
    if (point && problem.is_general()) extent = std::max(extent, (*point - origin).cwiseAbs().maxCoeff());
  for (const auto& line : problem.fixed_lines)
    if (line) extent = std::max(extent, (line->point - origin).cwiseAbs().maxCoeff());
  for (const auto& plane : problem.fixed_planes)
    if (plane) extent = std::max(extent, std::abs(plane->offset - plane->normal.dot(origin)));
  return extent;
}

/// The largest length of a relation or coordinate of a body.
double general_extent(const ProblemStatement& problem) {
  double extent = 0;
  for (const Relation& relation : problem.relations) {
    if (relation.form == Relation::Form::length) extent = std::max(extent, std::abs(relation.given.value));
    if (relation.form == Relation::Form::squared) extent = std::max(extent, std::sqrt(relation.given.value));
  }
  for (const RigidBody& body : problem.bodies)
    for (const BodyElement& element : body.elements)
      for (const Decimal& number : element.numbers) extent = std::max(extent, std::abs(number.value));
  return extent;
}

int exponent_of(double length) {
  int exponent = 0;
  std::frexp(length, &exponent);
  return exponent - 1;
}

void require_sound_bends(const ProblemStatement& problem) {
  for (const BentLength& bent : bent_lengths(problem))
    if (const auto defect = bend_defect(problem, bent))
      throw InputError("problem", "/interpolation/bends/" + problem.constraints[bent.constraint].id,
                       defect->what, defect->remedy);
}

/// Right-handed axes whose first is along `x` and whose second lies in the half plane of `y`; where a
/// direction vanishes, any that completes the frame.
Eigen::Matrix3d axes_from(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  const Eigen::Vector3d first =
      x.stableNormalized().norm() > 0 ? x.stableNormalized() : Eigen::Vector3d::UnitX();
  Eigen::Vector3d second = (y - first * first.dot(y)).stableNormalized();
  second = (second - first * first.dot(second)).stableNormalized();
  if (second.norm() == 0) second = first.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes.row(0) = first;
  axes.row(1) = second;
  axes.row(2) = first.cross(second);
  return axes;
}

/// Towards a point, along a line, or along a plane's normal.
Eigen::Vector3d direction_of(const ProblemStatement& problem, int entity, const Eigen::Vector3d& origin,
                             const Figure& figure) {
  if (problem.is_point(entity)) return figure.points.col(entity) - origin;
  if (problem.is_line(entity))
    return figure.lines[static_cast<std::size_t>(problem.line_of(entity))].direction;
  return figure.planes[static_cast<std::size_t>(problem.plane_of(entity))].normal;
}

/// The point of one line that is nearest to another one.
Eigen::Vector3d nearest_to(const LinePosition& other, const LinePosition& line) {
  const double cosine = line.direction.dot(other.direction);
  const Eigen::Vector3d across = line.direction - cosine * other.direction;
  return line.point + across.dot(other.point - line.point) / across.dot(line.direction) * line.direction;
}

/// Where a line and a plane meet.
Eigen::Vector3d meeting(const LinePosition& line, const PlanePosition& plane) {
  const double height = plane.offset - plane.normal.dot(line.point);
  return line.point + height / plane.normal.dot(line.direction) * line.direction;
}

/// Of a point, of the point of a line nearest to the first axis, or where a plane meets that; 0 without an entity.
double first_coordinate(const ProblemStatement& problem, int entity, const Figure& figure) {
  if (entity < 0) return 0;
  if (problem.is_point(entity)) return figure.points(0, entity);
  if (problem.is_plane(entity)) {
    const PlanePosition& plane = figure.planes[static_cast<std::size_t>(problem.plane_of(entity))];
    return plane.offset / plane.normal[0];
  }
  const LinePosition& line = figure.lines[static_cast<std::size_t>(problem.line_of(entity))];
  const auto across = line.direction.tail<2>();
  return line.point[0] - line.direction[0] * across.dot(line.point.tail<2>()) / across.squaredNorm();
}

/// See Reference. Precondition: it has all that it needs.
Eigen::Vector3d origin_of(const ProblemStatement& problem, const Reference& reference, const Figure& figure) {
  if (reference.origin >= 0) return figure.points.col(reference.origin);
  const auto line = [&](int entity) {
    return figure.lines[static_cast<std::size_t>(problem.line_of(entity))];
  };
  const auto plane = [&](int entity) {
    return figure.planes[static_cast<std::size_t>(problem.plane_of(entity))];
  };
  if (reference.axis < 0)
    return first_coordinate(problem, reference.height, figure) * Eigen::Vector3d::UnitX();
  if (problem.is_line(reference.axis)) {
    const LinePosition axis = line(reference.axis);
    if (problem.is_line(reference.plane)) return nearest_to(line(reference.plane), axis);
    if (problem.is_plane(reference.plane)) return meeting(axis, plane(reference.plane));
    return axis.point + axis.direction.dot(figure.points.col(reference.plane) - axis.point) * axis.direction;
  }
  const PlanePosition a = plane(reference.axis);
  if (reference.height < 0) return meeting(line(reference.plane), a);
  if (problem.is_point(reference.height)) return meeting({figure.points.col(reference.height), a.normal}, a);
  const PlanePosition b = plane(reference.plane), c = plane(reference.height);
  const Eigen::Vector3d along = a.normal.cross(b.normal);
  const Eigen::Vector3d point =
      (a.offset * b.normal.cross(along) + b.offset * along.cross(a.normal)) / along.squaredNorm();
  return meeting({point, along}, c);
}

FramePose motion_to_elements(const ProblemStatement& problem, const Reference& reference,
                             const Figure& figure) {
  FramePose motion;
  motion.origin = origin_of(problem, reference, figure);
  if (reference.axis < 0 && reference.plane < 0) return motion;
  const Eigen::Vector3d x = reference.axis < 0 ? Eigen::Vector3d::UnitX()
                                               : direction_of(problem, reference.axis, motion.origin, figure);
  Eigen::Vector3d y(-x.y(), x.x(), 0);
  if (problem.dimension == 3)
    y = reference.plane < 0 ? Eigen::Vector3d::UnitY()
                            : direction_of(problem, reference.plane, motion.origin, figure);
  motion.axes = axes_from(x, y);
  return motion;
}

/// Whether the reference has what tells where a scene's frame is: without a point, two directions at least, one of a
/// line or all of three planes, unless given elements tell the first axis.
bool is_complete(const ProblemStatement& problem, const Reference& reference) {
  if (reference.origin >= 0) return true;
  if (problem.file_frame && reference.axis < 0) return true;
  return reference.axis >= 0 && reference.plane >= 0 &&
         (problem.is_line(reference.axis) || problem.is_line(reference.plane) || reference.height >= 0);
}

/// The line becomes the x-axis and the height point lies on the z-axis, z ≥ 0.
FramePose motion_to_line(const Reference& reference, const Figure& figure) {
  const LinePosition& line = figure.lines[reference.line];
  FramePose motion;
  motion.origin = line.point;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  if (reference.height >= 0) {
    const Eigen::Vector3d height = figure.points.col(reference.height);
    motion.origin += line.direction * line.direction.dot(height - line.point);
    up = height - motion.origin;
  }
  const Eigen::Matrix3d axes = axes_from(line.direction, up);
  motion.axes.row(0) = axes.row(0);
  motion.axes.row(1) = -axes.row(2);
  motion.axes.row(2) = axes.row(1);
  return motion;
}

/// The coordinates that the frame makes zero, exactly zero.
void clear_frame_zeros(const ProblemStatement& problem, const Reference& reference, Figure& figure) {
  if (reference.line >= 0) {
    figure.lines[reference.line] = LinePosition{};
    if (reference.height >= 0) figure.points.col(reference.height).head<2>().setZero();
    return;
  }
  for (const int entity : {reference.origin, reference.axis, reference.plane, reference.height})
    for (int axis = 0; entity >= 0 && problem.is_point(entity) && axis < 3; ++axis)
      if (is_zero_in_frame(problem, reference, entity, axis)) figure.points(axis, entity) = 0;
}

/// A complex rotation costs accuracy: a figure that is in the frame already is left alone.
Figure complex_in_line_frame(const Figure& figure, const Reference& reference) {
  const LinePosition &line = figure.lines[reference.line],
                     &imaginary = figure.imaginary_lines[reference.line];
  const auto height = figure.points.col(reference.height), lower = figure.imaginary.col(reference.height);
  const bool is_there = line.point.isZero(0) && line.direction == Eigen::Vector3d::UnitX() &&
                        imaginary.point.isZero(0) && imaginary.direction.isZero(0) &&
                        height.head<2>().isZero(0) && lower.head<2>().isZero(0) && height[2] > 0;
  return is_there ? figure : moved_to_line(figure, reference.line, reference.height);
}

/// Changes the sign of coordinate `axis` of everything.
void mirror(Figure& figure, int axis) {
  figure.points.row(axis) *= -1;
  if (figure.imaginary.cols() > 0) figure.imaginary.row(axis) *= -1;
  for (auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (LinePosition& line : *lines) {
      line.point[axis] *= -1;
      line.direction[axis] *= -1;
    }
  for (auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (PlanePosition& plane : *planes) plane.normal[axis] *= -1;
}

/// Of general scenes a solver leaves the frame up to half-turns about its axes.
Figure half_turned(Figure figure, const Reference& reference, int dimension) {
  const auto is_point = [&](int entity) { return entity >= 0 && entity < figure.points.cols(); };
  if (is_point(reference.axis) && figure.points(0, reference.axis) < 0) {
    mirror(figure, 0);
    mirror(figure, 1);
  }
  if (dimension == 3 && is_point(reference.axis) && is_point(reference.plane) &&
      figure.points(1, reference.plane) < 0) {
    mirror(figure, 1);
    mirror(figure, 2);
  }
  return figure;
}

/// Mirrors the figure along `axis` unless the first point that is off the mirror has a positive coordinate, or where all are
/// in it the first line's point, or the first normal of a plane. Of a complex coordinate the real part decides, or the
/// imaginary part where that vanishes. `threshold`: relative to the scene's size.
void make_first_positive(Figure& figure, int axis, double size, double threshold) {
  const auto decides = [&](double re, double im, double unit) {
    const double deciding = std::abs(re) <= threshold * unit ? im : re;
    if (std::abs(deciding) <= threshold * unit) return false;
    if (deciding < 0) mirror(figure, axis);
    return true;
  };
  const bool is_real = figure.is_real();
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
    if (decides(figure.points(axis, i), is_real ? 0 : figure.imaginary(axis, i), size)) return;
  for (std::size_t i = 0; i < figure.lines.size(); ++i)
    if (decides(figure.lines[i].point[axis], is_real ? 0 : figure.imaginary_lines[i].point[axis], size))
      return;
  for (std::size_t i = 0; i < figure.planes.size(); ++i)
    if (decides(figure.planes[i].normal[axis], is_real ? 0 : figure.imaginary_planes[i].normal[axis], 1))
      return;
}

}  // namespace

Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene Scene::unchecked(ProblemStatement problem) { return {std::move(problem), Unchecked()}; }

Scene::Scene(ProblemStatement problem)
    : Scene((require_well_posed(problem, "problem"), require_sound_bends(problem), std::move(problem)),
            Unchecked()) {}

Scene::Scene(ProblemStatement problem, Unchecked)
    : problem_(std::move(problem)), anchored_(problem_.is_anchored()) {
  double longest = 0;
  for (const DistanceConstraint& c : problem_.constraints) longest = std::max(longest, c.length());
  if (longest == 0) longest = std::max(fixed_extent(problem_), general_extent(problem_));
  if (longest > 0) unit_exponent_ = exponent_of(longest);

  for (const DistanceConstraint& c : problem_.constraints) {
    const int exponent = c.is_squared ? -2 * unit_exponent_ : -unit_exponent_;
    const double given = std::ldexp(c.given.value, exponent);
    target_lengths_.push_back(c.is_squared ? std::sqrt(given) : given);
  }
  size_ = std::ldexp(std::max({longest, fixed_extent(problem_), general_extent(problem_)}), -unit_exponent_);
  if (size_ == 0 && problem_.is_general()) size_ = 1;  // angles and incidences alone have no length
  reference_ = problem_.reference.value_or(default_reference(problem_));

  if (!problem_.sketch) return;
  sketch_ = in_frame(in_scene_unit(*problem_.sketch));
  for (int i = 0; i < constraint_count(); ++i) {
    const auto [a, b] = problem_.constraints[i].between;
    LengthPath path;
    if (problem_.is_point(a) && problem_.is_point(b))
      path.at_sketch = (sketch_->points.col(a) - sketch_->points.col(b)).norm();
    path.at_target = target_lengths_[i];
    length_paths_.push_back(path);
  }
  for (const BentLength& bent : bent_lengths(problem_))
    bend(length_paths_[bent.constraint], bent.coefficients);
}

/// Zeros at the end do not make it a polynomial of a higher degree.
void Scene::bend(LengthPath& path, const std::vector<double>& coefficients) const {
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    const double coefficient = std::ldexp(coefficients[i], -unit_exponent_);
    if (i == 0)
      path.bend = coefficient;
    else if (coefficient != 0 || !path.higher.empty())
      path.higher.insert(path.higher.begin(), coefficient);
  }
}

std::optional<Eigen::Vector3d> Scene::fixed_point(int point) const {
  const auto index = static_cast<std::size_t>(point);
  if (index >= problem_.fixed_points.size() || !problem_.fixed_points[index]) return std::nullopt;
  return problem_.fixed_points[index]->unaryExpr([this](double x) { return std::ldexp(x, -unit_exponent_); });
}

Figure Scene::in_frame(const Figure& figure, const Reference& reference) const {
  if (anchored_ || problem_.reference_body >= 0) return figure;
  if (problem_.is_general() && !is_complete(problem_, reference)) return figure;
  if (!figure.is_real() && problem_.is_general()) return half_turned(figure, reference, dimension());
  if (!figure.is_real())
    return reference.line >= 0
               ? complex_in_line_frame(figure, reference)
               : complex_figure(gcs::in_frame(complex_points(figure), dimension(), reference));
  const FramePose motion = reference.line >= 0 ? motion_to_line(reference, figure)
                                               : motion_to_elements(problem_, reference, figure);
  Figure result = as_seen_from(motion, figure);
  clear_frame_zeros(problem_, reference, result);
  return result;
}

Figure Scene::representative(const Figure& figure) const {
  Figure result = in_frame(figure);
  constexpr double threshold = 1e-9;
  if (!anchored_ && convention_of(problem_) == Convention::up_to_reflection) {
    if (reference_.line >= 0) make_first_positive(result, 0, size_, threshold);
    make_first_positive(result, reference_.line >= 0 || dimension() == 2 ? 1 : 2, size_, threshold);
  }
  return with_normalised_lines(std::move(result));
}

Figure Scene::in_file_unit(const Figure& figure) const {
  return in_file(figure, unit_exponent_, problem_.file_frame);
}
Figure Scene::in_scene_unit(const Figure& figure) const {
  return in_scene(figure, unit_exponent_, problem_.file_frame);
}

}  // namespace gcs
