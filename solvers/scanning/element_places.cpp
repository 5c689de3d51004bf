#include "solvers/scanning/element_places.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "solvers/construction/closed_forms.hpp"
#include "solvers/scanning/step_places.hpp"

namespace gcs {
namespace {

using Vector = Eigen::Vector3d;
using Angles = std::array<double, 2>;

/// A place, or where surfaces that miss each other are nearest.
struct Spot {
  Vector at;
  bool misses = false;
};

/// normal·x = offset; or, where both signs are meant, offset = middle ± half.
struct Cut {
  Vector normal;
  double middle = 0;
  double half = 0;

  std::vector<double> offsets() const {
    if (half == 0) return {middle};
    return {middle + half, middle - half};
  }
};

/// √(reach² − far²), 0 where the difference is negative but far − reach within the slack; nothing where it is more.
struct Height {
  double value = 0;
  bool misses = false;
};
std::optional<Height> height_of(double reach, double far, double slack) {
  const double square = (reach - far) * (reach + far);
  if (square >= 0) return Height{std::sqrt(square)};
  if (std::abs(far) - reach <= slack) return Height{0, true};
  return std::nullopt;
}

/// Where a sphere around the origin meets one or two planes: at an angle on their circle, or on both sides of their common
/// line.
std::vector<Spot> on_cut_sphere(double radius, const Vector& first, double first_offset, const Cut* second,
                                double second_offset, double angle, double slack) {
  const double length = first.norm();
  const Vector axis = first / length;
  const double along = first_offset / length;
  const auto circle = height_of(radius, along, slack);
  if (!circle) return {};
  if (second == nullptr) {
    const Vector u = axis.unitOrthogonal();
    return {{along * axis + circle->value * (std::cos(angle) * u + std::sin(angle) * axis.cross(u)),
             circle->misses}};
  }
  const Vector within = second->normal - second->normal.dot(axis) * axis;
  const double gap = within.norm();
  const double further = (second_offset - along * second->normal.dot(axis)) / gap;
  const auto rest = height_of(circle->value, further, slack);
  if (!rest) return {};
  const Vector foot =
      along * axis + (rest->misses ? std::copysign(circle->value, further) : further) * within / gap;
  const Vector off = rest->value * axis.cross(within / gap);
  if (rest->misses) return {{foot, true}};
  return {{foot + off, circle->misses}, {foot - off, circle->misses}};
}

/// Where a sphere around the origin meets the first two cuts, at angles what they leave open.
std::vector<Spot> on_sphere(double radius, const std::vector<Cut>& cuts, const Angles& angles, double slack) {
  if (cuts.empty()) {
    const double level = std::cos(angles[1]);
    return {{radius * Vector(level * std::cos(angles[0]), level * std::sin(angles[0]), std::sin(angles[1]))}};
  }
  const Cut* second = cuts.size() > 1 ? &cuts[1] : nullptr;
  std::vector<Spot> spots;
  for (const double offset : cuts[0].offsets())
    for (const double other : second != nullptr ? second->offsets() : std::vector<double>{0}) {
      const auto more = on_cut_sphere(radius, cuts[0].normal, offset, second, other, angles[0], slack);
      spots.insert(spots.end(), more.begin(), more.end());
    }
  return spots;
}

/// The places point + λ·direction at which |from + λ·along| is the reach.
std::vector<Spot> on_line(const LinePosition& line, const Vector& from, const Vector& along, double reach,
                          double slack) {
  const double square = along.squaredNorm();
  const double nearest = -from.dot(along) / square;
  const auto height = height_of(reach, (from + nearest * along).norm(), slack);
  if (!height) return {};
  const double off = height->value / std::sqrt(square);
  if (height->misses) return {{line.point + nearest * line.direction, true}};
  return {{line.point + (nearest + off) * line.direction}, {line.point + (nearest - off) * line.direction}};
}

/// What is left of a vector beside a direction of length 1.
Vector beside(const Vector& vector, const Vector& direction) {
  return vector - vector.dot(direction) * direction;
}

/// The instruction of one step in one figure.
class PlacingInFigure {
 public:
  PlacingInFigure(const ProblemStatement& problem, const ElementStep& step, const Figure& figure,
                  const Angles& angles, double slack, double slack_of_directions)
      : problem_(problem),
        step_(step),
        figure_(figure),
        angles_(angles),
        slack_(slack),
        slack_of_directions_(slack_of_directions) {}

  std::vector<PlacedElement> places() const {
    std::vector<PlacedElement> placed;
    if (problem_.is_point(step_.place)) {
      for (const Spot& spot : of_point()) put_point(spot, placed);
    } else if (problem_.is_plane(step_.place)) {
      for (const Spot& normal : normals(cuts_of_normal())) put_plane(normal, placed);
    } else if (problem_.dimension == 2) {
      for (const Spot& normal : normals(cuts_of_line_normal())) put_line_across(normal, placed);
    } else {
      put_line(placed);
    }
    return placed;
  }

 private:
  // What is given, by kinds. Beside lines there is no more than one or two in use.

  std::vector<GivenFrom> from(int rank) const {
    std::vector<GivenFrom> result;
    for (const GivenFrom& one : step_.given)
      if (one.met_by != MetBy::one_direction && rank_of(problem_, one.other) == rank) result.push_back(one);
    return result;
  }
  std::optional<Vector> given_direction() const {
    for (const GivenFrom& one : step_.given)
      if (one.met_by == MetBy::one_direction) return direction(one);
    return std::nullopt;
  }
  Vector point(const GivenFrom& from) const { return figure_.points.col(from.other); }
  const PlanePosition& plane(const GivenFrom& from) const {
    return figure_.planes[static_cast<std::size_t>(problem_.plane_of(from.other))];
  }
  const LinePosition& line(const GivenFrom& from) const {
    return figure_.lines[static_cast<std::size_t>(problem_.line_of(from.other))];
  }
  /// Of a line, or the normal of a plane.
  Vector direction(const GivenFrom& from) const {
    return problem_.is_plane(from.other) ? plane(from).normal : line(from).direction;
  }
  /// A right angle to the left of a line in the plane.
  static Vector across(const LinePosition& line) { return {-line.direction.y(), line.direction.x(), 0}; }

  // Points.

  std::vector<Spot> of_point() const {
    if (step_.is_origin) return {{Vector::Zero()}};
    const std::vector<GivenFrom> lines = from(2);
    if (problem_.dimension == 3 && !lines.empty()) return of_point_by_line(lines);
    const std::vector<GivenFrom> spheres = from(0);
    if (spheres.empty()) return where_planes_meet(planes_of_point());
    return around(spheres.front(), cuts_of_point(spheres));
  }

  std::vector<Spot> around(const GivenFrom& sphere, const std::vector<Cut>& cuts) const {
    std::vector<Spot> spots = on_sphere(sphere.value, cuts, angles_, slack_);
    for (Spot& spot : spots) spot.at += point(sphere);
    return spots;
  }

  /// Planes that the point lies in: of the frame, at distances, and, in the plane, beside lines.
  std::vector<Cut> planes_of_point() const {
    std::vector<Cut> planes;
    for (const int axis : step_.zeros) planes.push_back({Vector::Unit(axis)});
    for (const GivenFrom& one : from(1)) planes.push_back({plane(one).normal, plane(one).offset + one.value});
    if (problem_.dimension == 2)
      for (const GivenFrom& one : from(2)) {
        const Vector normal = across(line(one));
        planes.push_back({normal, normal.dot(line(one).point), one.value});
      }
    return planes;
  }

  /// As seen from the first sphere's centre: zeros, further spheres, planes.
  std::vector<Cut> cuts_of_point(const std::vector<GivenFrom>& spheres) const {
    const Vector center = point(spheres.front());
    const double radius = spheres.front().value;
    std::vector<Cut> cuts = planes_of_point();
    for (Cut& cut : cuts) cut.middle -= cut.normal.dot(center);
    std::vector<Cut> common;
    for (std::size_t i = 1; i < spheres.size(); ++i) {
      const Vector way = point(spheres[i]) - center;
      const double other = spheres[i].value;
      common.push_back({way, ((radius - other) * (radius + other) + way.squaredNorm()) / 2});
    }
    cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(step_.zeros.size()), common.begin(), common.end());
    return cuts;
  }

  static std::vector<Spot> where_planes_meet(const std::vector<Cut>& planes) {
    Eigen::Matrix3d normals;
    for (int i = 0; i < 3; ++i) normals.row(i) = planes[static_cast<std::size_t>(i)].normal;
    const Eigen::PartialPivLU<Eigen::Matrix3d> lu(normals);
    std::vector<Spot> spots;
    for (const double a : planes[0].offsets())
      for (const double b : planes[1].offsets())
        for (const double c : planes[2].offsets()) spots.push_back({lu.solve(Vector(a, b, c))});
    return spots;
  }

  std::vector<Spot> of_point_by_line(const std::vector<GivenFrom>& lines) const {
    if (is_on_line(problem_, step_.place, lines.back())) return met_on(line(lines.back()), lines.front());
    const std::vector<GivenFrom> spheres = from(0);
    const std::vector<Cut> planes = planes_of_point();
    if (spheres.empty() && planes.size() == 2)
      return met_on(common_line(planes[0], planes[1]), lines.front());
    if (spheres.size() + planes.size() == 2) return of_circle_and_tube(spheres, lines.front());
    return met_on(ruling(lines.front()), lines.back());
  }

  /// The line that is at an angle on a cylinder.
  LinePosition ruling(const GivenFrom& tube) const {
    const LinePosition& axis = line(tube);
    const Vector u = axis.direction.unitOrthogonal();
    const Vector arm = std::cos(angles_[0]) * u + std::sin(angles_[0]) * axis.direction.cross(u);
    return {axis.point + tube.value * arm, axis.direction};
  }

  static LinePosition common_line(const Cut& a, const Cut& b) {
    const Vector along = a.normal.cross(b.normal);
    Eigen::Matrix3d normals;
    normals << a.normal.transpose(), b.normal.transpose(), along.transpose();
    return {normals.partialPivLu().solve(Vector(a.middle, b.middle, 0)), along.normalized()};
  }

  /// Where a line meets the first sphere or plane or, without these, the cylinder.
  std::vector<Spot> met_on(const LinePosition& on, const GivenFrom& tube) const {
    if (const auto spheres = from(0); !spheres.empty())
      return on_line(on, on.point - point(spheres[0]), on.direction, spheres[0].value, slack_);
    if (const auto planes = from(1); planes.size() == 1 && step_.zeros.empty()) {
      const double rate = plane(planes[0]).normal.dot(on.direction);
      const double short_of =
          plane(planes[0]).offset + planes[0].value - plane(planes[0]).normal.dot(on.point);
      return {{on.point + short_of / rate * on.direction}};
    }
    const LinePosition& axis = line(tube);
    return on_line(on, beside(on.point - axis.point, axis.direction), beside(on.direction, axis.direction),
                   tube.value, slack_);
  }

  /// The circle on the first sphere, in coordinates in which the cylinder is around the x-axis.
  std::vector<Spot> of_circle_and_tube(const std::vector<GivenFrom>& spheres, const GivenFrom& tube) const {
    const Cut cut = cuts_of_point(spheres).front();
    const double length = cut.normal.norm(), radius = spheres.front().value, along = cut.middle / length;
    const auto circle = height_of(radius, along, slack_);
    if (!circle) return {};
    const LinePosition& axis = line(tube);
    const Vector across = axis.direction.unitOrthogonal();
    Eigen::Matrix3d turn;
    turn << axis.direction.transpose(), across.transpose(), axis.direction.cross(across).transpose();
    const Vector origin = turn * (point(spheres.front()) - axis.point), normal = turn * (cut.normal / length);
    const HingeCircle hinge{along, circle->value};
    std::vector<Spot> spots;
    const auto append = [&](const Vector& at, bool misses) {
      spots.push_back({axis.point + turn.transpose() * at, misses});
    };
    for (const Vector& at : meet_cylinder(origin, normal, hinge, tube.value)) append(at, circle->misses);
    for (const Vector& at : extreme_distances_from_x_axis(origin, normal, hinge))
      if (std::abs(at.tail<2>().norm() - tube.value) <= slack_) append(at, true);
    return spots;
  }

  // Normals and directions.

  std::vector<Spot> normals(const std::vector<Cut>& cuts) const {
    if (const auto along = given_direction(); along && problem_.is_plane(step_.place))
      return {{*along}, {-*along}};
    return on_sphere(1, cuts, angles_, slack_of_directions_);
  }

  std::vector<Cut> cuts_of_normal() const {
    const std::vector<GivenFrom> points = from(0);
    std::vector<Cut> cuts;
    for (std::size_t i = 1; i < points.size(); ++i)
      cuts.push_back({point(points[i]) - point(points[0]), points[i].value - points[0].value});
    for (const GivenFrom& one : from(1)) cuts.push_back({plane(one).normal, one.value});
    for (const GivenFrom& one : from(2)) cuts.push_back({line(one).direction, 0, one.value});
    return cuts;
  }

  /// With the normal towards the first point.
  std::vector<Cut> cuts_of_line_normal() const {
    const std::vector<GivenFrom> points = from(0);
    std::vector<Cut> cuts{{Vector::UnitZ()}};
    for (std::size_t i = 1; i < points.size(); ++i)
      cuts.push_back({point(points[i]) - point(points[0]), -points[0].value, points[i].value});
    for (const GivenFrom& one : from(2)) cuts.push_back({across(line(one)), 0, one.value});
    if (const auto along = given_direction()) cuts.push_back({*along});
    return cuts;
  }

  /// Of a line through the first point.
  std::vector<Spot> directions_through(const GivenFrom& first) const {
    if (const auto along = given_direction()) return {{*along}};
    std::vector<Cut> cuts;
    for (const GivenFrom& one : from(0)) {
      const Vector way = point(one) - point(first);
      if (one.other == first.other) continue;
      if (is_on_line(problem_, step_.place, one)) return {{way.normalized()}};
      const auto along = height_of(way.norm(), one.value, slack_);
      if (!along) return {};
      cuts.push_back({way, 0, along->value});
    }
    for (const int rank : {1, 2})
      for (const GivenFrom& one : from(rank)) cuts.push_back({direction(one), 0, one.value});
    return on_sphere(1, cuts, angles_, slack_of_directions_);
  }

  // What is placed.

  void put_point(const Spot& spot, std::vector<PlacedElement>& placed) const {
    if (!spot.at.allFinite() || (step_.positive >= 0 && !(spot.at[step_.positive] > 0))) return;
    placed.push_back({figure_, spot.misses});
    placed.back().figure.points.col(step_.place) = spot.at;
  }
  void put_plane(const Spot& normal, std::vector<PlacedElement>& placed) const {
    if (!normal.at.allFinite()) return;
    const GivenFrom first = from(0).front();
    placed.push_back({figure_, normal.misses});
    placed.back().figure.planes[static_cast<std::size_t>(problem_.plane_of(step_.place))] = {
        normal.at, normal.at.dot(point(first)) - first.value};
  }
  void put_line_across(const Spot& normal, std::vector<PlacedElement>& placed) const {
    const GivenFrom first = from(0).front();
    append_line({point(first) - first.value * normal.at, {normal.at.y(), -normal.at.x(), 0}}, normal.misses,
                placed);
  }
  void put_line(std::vector<PlacedElement>& placed) const {
    for (const GivenFrom& one : from(0))
      if (is_on_line(problem_, step_.place, one)) {
        for (const Spot& along : directions_through(one))
          append_line({point(one), along.at}, along.misses, placed);
        return;
      }
    put_line_along(*given_direction(), placed);
  }
  /// In the plane at a right angle to it the line is a point on circles.
  void put_line_along(const Vector& along, std::vector<PlacedElement>& placed) const {
    std::vector<GivenFrom> circles = from(0);
    const Vector center = beside(point(circles[0]), along);
    std::vector<Cut> cuts{{along}};
    for (std::size_t i = 1; i < circles.size(); ++i) {
      const Vector way = beside(point(circles[i]), along) - center;
      const double a = circles[0].value, b = circles[i].value;
      cuts.push_back({way, ((a - b) * (a + b) + way.squaredNorm()) / 2});
    }
    for (const Spot& spot : on_sphere(circles[0].value, cuts, angles_, slack_))
      append_line({center + spot.at, along}, spot.misses, placed);
  }
  void append_line(const LinePosition& at, bool misses, std::vector<PlacedElement>& placed) const {
    if (!at.point.allFinite() || !at.direction.allFinite()) return;
    placed.push_back({figure_, misses});
    placed.back().figure.lines[static_cast<std::size_t>(problem_.line_of(step_.place))] = at;
  }

  const ProblemStatement& problem_;
  const ElementStep& step_;
  const Figure& figure_;
  const Angles& angles_;
  double slack_, slack_of_directions_;
};

}  // namespace

std::vector<PlacedElement> ElementPlaces::of(const ElementStep& step, const Figure& figure,
                                             const Angles& angles) const {
  return PlacingInFigure(problem_, step, figure, angles, slack_, slack_of_directions_).places();
}

}  // namespace gcs
