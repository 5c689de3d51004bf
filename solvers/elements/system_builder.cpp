#include "solvers/elements/system_builder.hpp"

#include <algorithm>

#include "solvers/elements/element_kinds.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

SystemBuilder::SystemBuilder(const Scene& scene)
    : scene_(scene),
      frame_(scene),
      turnings_(scene.problem()),
      next_turning_(8),
      points_(scene.problem().points.size()),
      has_place_(points_.size()),
      lines_(scene.problem().lines.size()),
      planes_(scene.problem().planes.size()),
      has_line_(lines_.size()),
      has_plane_(planes_.size()) {
  place_bodies();
  place_points();
  place_planes();
  place_lines();
}

LinearForm SystemBuilder::unknown(SignMask mask) {
  system_.mirror.push_back(mask);
  return {{{system_.unknowns++}}, {}};
}

VectorForm SystemBuilder::vector(SignMask turning) {
  VectorForm result;
  for (int axis = 0; axis < dimension(); ++axis)
    result[static_cast<std::size_t>(axis)] = unknown(frame_.axis(axis) ^ turning);
  return result;
}

VectorForm SystemBuilder::pseudo_vector() { return vector(frame_.mirror()); }

SignMask SystemBuilder::new_turning() {
  const SignMask result = next_turning_;
  next_turning_ <<= 1;
  return result;
}

void SystemBuilder::add(QuadraticEquation equation, int value) {
  system_.equations.push_back(std::move(equation));
  value_of_.push_back(value);
  owner_of_.push_back(value == no_value ? owner_ : value);
}

void SystemBuilder::define(std::function<ComplexValues(const Placement&, const ComplexValues&)> values) {
  definitions_.push_back(std::move(values));
}

ExactNumber SystemBuilder::length(const Decimal& given) const {
  ExactNumber number = exactly(given.value);
  number.decimal = given.text;
  number.exponent = -scene_.unit_exponent();
  return number;
}

ExactNumber SystemBuilder::square(const Decimal& given, bool is_squared) const {
  ExactNumber number = length(given);
  number.is_squared = !is_squared;
  if (is_squared) number.exponent *= 2;
  return number;
}

/// Points of a body stand where its pose puts them; one that was in a body before is joined by equations.
void SystemBuilder::place(const PlacedBody& body) {
  for (const BodyPoint& placed : body.points) {
    const auto p = static_cast<std::size_t>(placed.point);
    const VectorForm& form = placed.at;
    if (!has_place_[p] && !placed.numbers.empty()) arms_.emplace(placed.point, placed);
    for (std::size_t axis = 0; has_place_[p] && axis < static_cast<std::size_t>(dimension()); ++axis)
      add(Equation().plus(form[axis]).minus(points_[p][axis]).equals());
    if (!has_place_[p]) points_[p] = form;
    has_place_[p] = true;
  }
  for (const auto& [line, at] : body.lines) {
    lines_[static_cast<std::size_t>(line)] = at;
    has_line_[static_cast<std::size_t>(line)] = true;
  }
  for (const auto& [plane, at] : body.planes) {
    planes_[static_cast<std::size_t>(plane)] = at;
    has_plane_[static_cast<std::size_t>(plane)] = true;
  }
}

void SystemBuilder::place_bodies() {
  const int at_rest = frame_.body();
  const auto& bodies = problem().bodies;
  if (at_rest >= 0) place(body_at_rest(*this, bodies[static_cast<std::size_t>(at_rest)]));
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body)
    if (body != at_rest) place(free_body(*this, bodies[static_cast<std::size_t>(body)]));
}

void SystemBuilder::place_points() {
  for (int point = 0; point < static_cast<int>(points_.size()); ++point) {
    if (has_place_[static_cast<std::size_t>(point)]) continue;
    for (int axis = 0; axis < dimension(); ++axis) {
      LinearForm& form = points_[static_cast<std::size_t>(point)][static_cast<std::size_t>(axis)];
      if (scene_.fixed_point(point)) {
        form = constant_form(given_coordinate(scene_, point, axis));
        continue;
      }
      if (frame_.is_zero(point, axis)) continue;
      form = unknown(frame_.axis(axis));
      define([point, axis](const Placement& at, const ComplexValues&) {
        return ComplexValues{at.points(axis, point)};
      });
    }
  }
}

void SystemBuilder::place_planes() {
  for (int plane = 0; plane < static_cast<int>(planes_.size()); ++plane) {
    if (has_plane_[static_cast<std::size_t>(plane)]) continue;
    SignMask turning = 0;
    if (const int set = turnings_.of_plane(plane); set >= 0) {
      SignMask& of_set = turning_of_set_[set];
      if (of_set == 0) of_set = new_turning();
      turning = of_set;
    }
    planes_[static_cast<std::size_t>(plane)] = free_plane(
        *this, turning, [plane](const Placement& at) { return at.planes[static_cast<std::size_t>(plane)]; });
  }
}

/// A line that is perpendicular to a plane has its direction, and parallel lines have one.
void SystemBuilder::place_lines() {
  const auto lines = static_cast<int>(lines_.size());
  std::vector<bool> is_placed = has_line_;
  const auto index = [](int line) { return static_cast<std::size_t>(line); };
  for (int line = 0; line < lines; ++line) {
    if (is_placed[index(line)] && !has_line_[index(line)]) continue;
    const std::vector<int> parallel = parallel_lines(problem(), line);
    const std::vector<int> across = planes_across(problem(), parallel);
    LineForms first;
    if (has_line_[index(line)]) {
      first = lines_[index(line)];
    } else if (std::ranges::any_of(parallel, [&](int other) { return has_line_[index(other)]; })) {
      continue;  // it gets its direction with that line
    } else if (across.empty()) {
      const SignMask turning = new_turning();
      first = free_line(*this, turning,
                        [line](const Placement& at) { return at.lines[static_cast<std::size_t>(line)]; });
    } else {
      const PlaneForms& plane = planes_[index(across.front())];
      first = line_along(*this, plane.normal, plane.turning, line);
    }
    for (const int other : parallel) {
      if (is_placed[index(other)]) continue;
      lines_[index(other)] = other == line ? first : line_along(*this, first.direction, first.turning, other);
      is_placed[index(other)] = true;
    }
  }
}

LineForms SystemBuilder::further_line(std::vector<int> through) {
  return free_line(*this, new_turning(), [through = std::move(through)](const Placement& at) {
    const Eigen::Vector3cd a = at.points.col(through[0]), b = at.points.col(through[1]);
    return normalised(ComplexLine{a, b - a});
  });
}

PlaneForms SystemBuilder::further_plane(std::vector<int> through) {
  return free_plane(*this, new_turning(), [through = std::move(through)](const Placement& at) {
    const Eigen::Vector3cd a = at.points.col(through[0]), b = at.points.col(through[1]),
                           c = at.points.col(through[2]);
    const Eigen::Vector3cd normal =
        unit_vector(cross_product(Eigen::Vector3cd(b - a), Eigen::Vector3cd(c - a)));
    return ComplexPlane{normal, bilinear_product(normal, a)};
  });
}

SegmentForms SystemBuilder::segment(const Operand& segment) {
  const auto [a, b] = std::minmax(segment.entity, segment.end);
  auto found = segments_.find({a, b});
  if (found == segments_.end()) {
    SignMask turning = 0;
    if (const int set = turnings_.of_segment(a, b); set >= 0) {
      SignMask& of_set = turning_of_segments_[set];
      if (of_set == 0) of_set = new_turning();
      turning = of_set;
    }
    SegmentForms forms{unknown(turning), vector(turning), turning};
    define([a = a, b = b, d = dimension()](const Placement& at, const ComplexValues&) {
      const Eigen::Vector3cd way = at.points.col(b) - at.points.col(a);
      const std::complex<double> length = std::sqrt(bilinear_product(way, way));
      ComplexValues values{length};
      const ComplexValues direction = components(way / length, d);
      values.insert(values.end(), direction.begin(), direction.end());
      return values;
    });
    for (int axis = 0; axis < dimension(); ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      add(Equation().plus(point(b)[i]).minus(point(a)[i]).minus(forms.length, forms.direction[i]).equals());
    }
    add(Equation().plus(forms.direction, forms.direction).equals(exactly(1)));
    for (int i = 0; i < scene_.constraint_count(); ++i) {
      const DistanceConstraint& c = problem().constraints[static_cast<std::size_t>(i)];
      if (std::minmax(c.between[0], c.between[1]) != std::pair<const int&, const int&>(a, b)) continue;
      if (c.is_squared)
        add(Equation().plus(forms.length, forms.length).equals(given_square(scene_, i)), i);
      else
        add(Equation().plus(forms.length).equals(length(c.given)), i);
    }
    found = segments_.emplace(std::pair(a, b), forms).first;
  }
  SegmentForms forms = found->second;
  if (segment.entity > segment.end) forms.direction = negated(forms.direction);
  return forms;
}

bool SystemBuilder::is_stated_by_segment(int constraint) const {
  const auto [a, b] = problem().constraints[static_cast<std::size_t>(constraint)].between;
  return segments_.count(std::minmax(a, b)) > 0;
}

ComplexValues SystemBuilder::values(const Placement& placement) const {
  ComplexValues x;
  for (const auto& define : definitions_) {
    const ComplexValues more = define(placement, x);
    x.insert(x.end(), more.begin(), more.end());
  }
  return x;
}

Placement SystemBuilder::placement(const ComplexValues& x) const {
  Placement result;
  result.points.resize(3, static_cast<Eigen::Index>(points_.size()));
  for (std::size_t i = 0; i < points_.size(); ++i)
    result.points.col(static_cast<Eigen::Index>(i)) = vector_at(points_[i], x);
  for (const LineForms& line : lines_)
    result.lines.push_back(normalised(ComplexLine{vector_at(line.foot, x), vector_at(line.direction, x)}));
  for (const PlaneForms& plane : planes_)
    result.planes.push_back({vector_at(plane.normal, x), value_at(plane.offset, x)});
  return result;
}

std::vector<bool> SystemBuilder::turned_planes() const {
  std::vector<bool> turned;
  for (const PlaneForms& plane : planes_) turned.push_back(plane.turning != 0);
  return turned;
}

Eigen::Vector3cd vector_at(const VectorForm& forms, const ComplexValues& x) {
  return {value_at(forms[0], x), value_at(forms[1], x), value_at(forms[2], x)};
}

ComplexValues components(const Eigen::Vector3cd& vector, int dimension) {
  return ComplexValues(vector.begin(), vector.begin() + dimension);
}

Eigen::Vector3cd unit_vector(const Eigen::Vector3cd& v) { return v / std::sqrt(bilinear_product(v, v)); }

}  // namespace gcs
