#include "solvers/elements/scene_elements.hpp"

#include <algorithm>

#include "solvers/elements/element_kinds.hpp"
#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

class Placing {
 public:
  explicit Placing(SystemBuilder& builder)
      : builder_(builder),
        has_point_(problem().points.size()),
        has_line_(problem().lines.size()),
        has_plane_(problem().planes.size()) {}

  void run() {
    place_bodies();
    place_points();
    place_planes();
    place_lines();
  }

 private:
  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  const ProblemStatement& problem() const { return builder_.problem(); }

  void place_bodies() {
    const int at_rest = builder_.frame().body();
    if (at_rest >= 0) place(body_at_rest(builder_, problem().bodies[index(at_rest)]));
    for (int body = 0; body < static_cast<int>(problem().bodies.size()); ++body)
      if (body != at_rest) place(free_body(builder_, problem().bodies[index(body)]));
  }

  /// A point that was in a body before is joined by equations.
  void place(const PlacedBody& body) {
    for (const BodyPoint& placed : body.points) {
      if (has_point_[index(placed.point)]) {
        join(placed);
        continue;
      }
      if (!placed.numbers.empty()) builder_.put_arm(placed);
      builder_.put_point(placed.point, placed.at);
      has_point_[index(placed.point)] = true;
    }
    for (const auto& [line, at] : body.lines) {
      builder_.put_line(line, at);
      has_line_[index(line)] = true;
    }
    for (const auto& [plane, at] : body.planes) {
      builder_.put_plane(plane, at);
      has_plane_[index(plane)] = true;
    }
  }

  void join(const BodyPoint& placed) {
    for (std::size_t axis = 0; axis < index(builder_.dimension()); ++axis)
      builder_.add(Equation().plus(placed.at[axis]).minus(builder_.point(placed.point)[axis]).equals());
  }

  void place_points() {
    for (int point = 0; point < static_cast<int>(has_point_.size()); ++point) {
      if (has_point_[index(point)]) continue;
      VectorForm at;
      for (int axis = 0; axis < builder_.dimension(); ++axis) at[index(axis)] = coordinate(point, axis);
      builder_.put_point(point, at);
    }
  }

  LinearForm coordinate(int point, int axis) {
    const Scene& scene = builder_.scene();
    if (scene.fixed_point(point)) return constant_form(given_coordinate(scene, point, axis));
    if (builder_.frame().is_zero(point, axis)) return {};
    const LinearForm form = builder_.unknown(builder_.frame().axis(axis));
    builder_.define([point, axis](const Placement& at, const ComplexValues&) {
      return ComplexValues{at.points(axis, point)};
    });
    return form;
  }

  void place_planes() {
    for (int plane = 0; plane < static_cast<int>(has_plane_.size()); ++plane) {
      if (has_plane_[index(plane)]) continue;
      builder_.put_plane(plane, free_plane(builder_, builder_.turning_of_plane(plane),
                                           [plane](const Placement& at) { return at.planes[index(plane)]; }));
    }
  }

  /// Lines of bodies first, since those that are parallel to them have their directions.
  void place_lines() {
    for (const bool is_of_body : {true, false})
      for (int line = 0; line < static_cast<int>(has_line_.size()); ++line)
        if (has_line_[index(line)] == is_of_body) place_with_parallels(line);
  }

  void place_with_parallels(int line) {
    const std::vector<int> parallel = parallel_lines(problem(), line);
    const bool is_there = has_line_[index(line)];
    if (!is_there) builder_.put_line(line, first_line(line, parallel));
    has_line_[index(line)] = true;
    const LineForms& first = builder_.line(problem().line_entity(line));
    const VectorForm direction = first.direction;
    const SignMask turning = first.turning;
    for (const int other : parallel) {
      if (has_line_[index(other)]) continue;
      builder_.put_line(other, line_along(builder_, direction, turning, other));
      has_line_[index(other)] = true;
    }
  }

  LineForms first_line(int line, const std::vector<int>& parallel) {
    const std::vector<int> across = planes_across(problem(), parallel);
    if (across.empty())
      return free_line(builder_, builder_.new_turning(),
                       [line](const Placement& at) { return at.lines[index(line)]; });
    const PlaneForms plane = builder_.plane(problem().plane_entity(across.front()));
    return line_along(builder_, plane.normal, plane.turning, line);
  }

  SystemBuilder& builder_;
  std::vector<bool> has_point_, has_line_, has_plane_;
};

}  // namespace

void place_elements(SystemBuilder& builder) { Placing(builder).run(); }

}  // namespace gcs
