#include "solvers/model/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "solvers/model/bend_defect.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/structure/structure.hpp"

namespace gcs {
namespace {

/// The largest coordinate of a fixed position that distances are measured from.
double fixed_extent(const ProblemStatement& problem) {
  double extent = 0;
  for (const DistanceConstraint& constraint : problem.constraints)
    for (const int end : constraint.between)
      if (problem.is_point(end) && problem.is_fixed(end))
        extent = std::max(extent, problem.fixed_points[end]->cwiseAbs().maxCoeff());
  for (const auto& line : problem.fixed_lines)
    if (line) extent = std::max(extent, line->point.cwiseAbs().maxCoeff());
  for (const auto& plane : problem.fixed_planes)
    if (plane) extent = std::max(extent, std::abs(plane->offset));
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

bool constrained(const std::set<std::pair<int, int>>& pairs, int a, int b) {
  return pairs.count({std::min(a, b), std::max(a, b)}) > 0;
}

std::set<std::pair<int, int>> constrained_pairs(const ProblemStatement& problem) {
  std::set<std::pair<int, int>> pairs;
  for (const DistanceConstraint& c : problem.constraints)
    pairs.insert(std::minmax(c.between[0], c.between[1]));
  return pairs;
}

/// Origin, axis and (in space) plane: the first that are pairwise constrained, in the order of the
/// constraints.
Reference point_reference(const ProblemStatement& problem) {
  const auto pairs = constrained_pairs(problem);
  const int n = static_cast<int>(problem.points.size());
  Reference fallback{0, n > 1 ? 1 : -1, problem.dimension == 3 && n > 2 ? 2 : -1};
  for (const DistanceConstraint& c : problem.constraints) {
    if (!problem.is_point(c.between[0]) || !problem.is_point(c.between[1])) continue;
    Reference candidate{c.between[0], c.between[1]};
    if (problem.dimension == 2) return candidate;
    for (int p = 0; p < n; ++p)
      if (constrained(pairs, p, candidate.origin) && constrained(pairs, p, candidate.axis)) {
        candidate.plane = p;
        return candidate;
      }
  }
  return fallback;
}

Reference default_reference(const ProblemStatement& problem) {
  return problem.lines.empty() || problem.is_general() ? point_reference(problem) : line_reference(problem);
}

void require_sound_bends(const ProblemStatement& problem) {
  for (const BentLength& bent : bent_lengths(problem))
    if (const auto defect = bend_defect(problem, bent))
      throw InputError("problem", "/interpolation/bends/" + problem.constraints[bent.constraint].id,
                       defect->what, defect->remedy);
}

/// Rows are the frame's axes.
struct RigidMotion {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

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

RigidMotion motion_to_points(const ProblemStatement& problem, const Reference& reference,
                             const Figure& figure) {
  RigidMotion motion;
  motion.origin = figure.points.col(reference.origin);
  if (reference.axis < 0) return motion;
  const Eigen::Vector3d x = figure.points.col(reference.axis) - motion.origin;
  Eigen::Vector3d y(-x.y(), x.x(), 0);
  if (problem.dimension == 3)
    y = reference.plane < 0 ? Eigen::Vector3d::UnitY()
                            : Eigen::Vector3d(figure.points.col(reference.plane) - motion.origin);
  motion.axes = axes_from(x, y);
  return motion;
}

/// The line becomes the x-axis and the height point lies on the z-axis, z ≥ 0.
RigidMotion motion_to_line(const Reference& reference, const Figure& figure) {
  const LinePosition& line = figure.lines[reference.line];
  RigidMotion motion;
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

Figure moved(const RigidMotion& motion, const Figure& figure) {
  Figure result = figure;
  result.points = motion.axes * (figure.points.colwise() - motion.origin);
  for (LinePosition& line : result.lines) {
    line.point = motion.axes * (line.point - motion.origin);
    line.direction = motion.axes * line.direction;
  }
  for (PlanePosition& plane : result.planes) {
    plane.offset -= plane.normal.dot(motion.origin);
    plane.normal = motion.axes * plane.normal;
  }
  return result;
}

/// The coordinates that the frame makes zero, exactly zero.
void clear_frame_zeros(const Reference& reference, Figure& figure) {
  if (reference.line >= 0) {
    figure.lines[reference.line] = LinePosition{};
    if (reference.height >= 0) figure.points.col(reference.height).head<2>().setZero();
    return;
  }
  figure.points.col(reference.origin).setZero();
  if (reference.axis >= 0) figure.points.col(reference.axis).tail<2>().setZero();
  if (reference.plane >= 0) figure.points(2, reference.plane) = 0;
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

/// The point of the line nearest to the origin, and the direction whose first non-zero component is positive.
LinePosition normalised(const LinePosition& line) {
  LinePosition result;
  result.direction = line.direction.stableNormalized();
  int lead = 0;
  while (lead < 2 && std::abs(result.direction[lead]) < 1e-9) ++lead;
  if (result.direction[lead] < 0) result.direction = -result.direction;
  result.point = line.point - result.direction * result.direction.dot(line.point);
  return result;
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
  if (reference.axis >= 0 && figure.points(0, reference.axis) < 0) {
    mirror(figure, 0);
    mirror(figure, 1);
  }
  if (dimension == 3 && reference.plane >= 0 && figure.points(1, reference.plane) < 0) {
    mirror(figure, 1);
    mirror(figure, 2);
  }
  return figure;
}

/// Mirrors the figure along `axis` unless the first point that is off the mirror has a positive coordinate.
/// Of a complex coordinate the real part decides, or the imaginary part where that vanishes.
void make_first_positive(Figure& figure, int axis, double threshold) {
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) {
    double deciding = figure.points(axis, i);
    if (!figure.is_real() && std::abs(deciding) <= threshold) deciding = figure.imaginary(axis, i);
    if (std::abs(deciding) <= threshold) continue;
    if (deciding < 0) mirror(figure, axis);
    return;
  }
}

}  // namespace

Reference line_reference(const ProblemStatement& problem) {
  Reference reference;
  reference.line = 0;
  const int line = static_cast<int>(problem.points.size());
  for (const DistanceConstraint& c : problem.constraints)
    if (c.between[0] == line || c.between[1] == line) {
      const int point = c.between[0] == line ? c.between[1] : c.between[0];
      if (reference.height < 0 || c.length() > 0) reference.height = point;
      if (c.length() > 0) break;
    }
  return reference;
}

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
  sketch_ = in_frame(problem_.sketch->scaled(-unit_exponent_));
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
  if (!figure.is_real() && problem_.is_general()) return half_turned(figure, reference, dimension());
  if (!figure.is_real())
    return reference.line >= 0
               ? complex_in_line_frame(figure, reference)
               : complex_figure(gcs::in_frame(complex_points(figure), dimension(), reference));
  const RigidMotion motion =
      reference.line >= 0 ? motion_to_line(reference, figure) : motion_to_points(problem_, reference, figure);
  Figure result = moved(motion, figure);
  clear_frame_zeros(reference, result);
  return result;
}

Figure Scene::representative(const Figure& figure) const {
  Figure result = in_frame(figure);
  const double threshold = 1e-9 * size_;
  if (!anchored_ && convention_of(problem_) == Convention::up_to_reflection) {
    if (reference_.line >= 0) make_first_positive(result, 0, threshold);
    make_first_positive(result, reference_.line >= 0 || dimension() == 2 ? 1 : 2, threshold);
  }
  if (result.is_real())
    for (LinePosition& line : result.lines) line = normalised(line);
  else
    set_complex_lines(normalised(complex_lines(result)), result);
  return result;
}

Figure Scene::in_file_unit(const Figure& figure) const { return figure.scaled(unit_exponent_); }
Figure Scene::in_scene_unit(const Figure& figure) const { return figure.scaled(-unit_exponent_); }

}  // namespace gcs
