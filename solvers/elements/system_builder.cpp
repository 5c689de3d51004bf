#include "solvers/elements/system_builder.hpp"

#include <algorithm>

#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {

SystemBuilder::SystemBuilder(const Scene& scene)
    : scene_(scene),
      frame_(scene),
      turnings_(scene.problem()),
      next_turning_(first_turning),
      points_(scene.problem().points.size()),
      lines_(scene.problem().lines.size()),
      planes_(scene.problem().planes.size()) {}

SystemBuilder::SystemBuilder(const SystemBuilder&) = default;
SystemBuilder::SystemBuilder(SystemBuilder&&) noexcept = default;
SystemBuilder::~SystemBuilder() = default;

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
  owner_of_.push_back(value < 0 ? owner_ : value);
}

void SystemBuilder::define(std::function<ComplexValues(const Placement&, const ComplexValues&)> values) {
  definitions_.push_back(std::move(values));
}

ExactNumber SystemBuilder::length(const Decimal& given) const { return given_length(scene_, given); }

ExactNumber SystemBuilder::square(const Decimal& given, bool is_squared) const {
  ExactNumber number = length(given);
  number.is_squared = !is_squared;
  if (is_squared) number.exponent *= 2;
  return number;
}

bool SystemBuilder::is_along_first_axis(int set) const {
  const int axis = frame_.reference().axis;
  return axis >= 0 && problem().is_plane(axis) && turnings_.of_plane(problem().plane_of(axis)) == set;
}

SignMask SystemBuilder::turning_of_plane(int plane) {
  const int set = turnings_.of_plane(plane);
  if (set < 0) return 0;
  SignMask& turning = turning_of_set_[set];
  if (turning == 0) turning = is_along_first_axis(set) ? frame_.axis(0) : new_turning();
  return turning;
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
      std::complex<double> length = std::sqrt(bilinear_product(way, way));
      if (std::ranges::find(at.turned_segments, std::array{a, b}) != at.turned_segments.end())
        length = -length;
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
