#include "harness/descriptions/scene_forms.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

LinearForm unknown_or(int unknown, const ExactNumber& number) {
  return unknown >= 0 ? LinearForm{{{unknown}}, {}} : LinearForm{{}, number};
}

/// Elements of a scene that has no system of elements.
class DistanceForms {
 public:
  DistanceForms(const Scene& scene, const SceneEquations& equations) : scene_(scene), equations_(equations) {}

  VectorForm point(int point) const {
    VectorForm forms;
    for (int axis = 0; axis < scene_.dimension(); ++axis)
      forms[static_cast<std::size_t>(axis)] =
          unknown_or(equations_.point_unknown(point, axis), given_coordinate(scene_, point, axis));
    return forms;
  }

  /// That which has no unknowns is the x-axis.
  LineForms line(int line) const {
    LineForms forms;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      forms.foot[at] = unknown_or(equations_.line_unknown(line, 0, axis), {});
      forms.direction[at] =
          unknown_or(equations_.line_unknown(line, 1, axis), exactly(axis == 0 ? 1.0 : 0.0));
    }
    return forms;
  }

 private:
  const Scene& scene_;
  const SceneEquations& equations_;
};

/// Σ factor·form, in doubles.
class Combination {
 public:
  Combination& plus(double factor, const LinearForm& form) {
    for (const ScaledUnknown& term : form.terms)
      add(term.unknown, factor * rounded_to_double(term.coefficient));
    return plus(factor * rounded_to_double(form.constant).real());
  }
  Combination& plus(double constant) {
    sum_.constant.value += constant;
    return *this;
  }
  LinearForm form() const { return sum_; }

 private:
  void add(int unknown, std::complex<double> coefficient) {
    const auto found = std::ranges::find(sum_.terms, unknown, &ScaledUnknown::unknown);
    if (found == sum_.terms.end())
      sum_.terms.push_back({unknown, exactly(coefficient)});
    else
      found->coefficient.value += coefficient;
  }

  LinearForm sum_;
};

/// x ↦ axesᵀ·x + origin, of x in a unit of 2^exponent.
class FileFrame {
 public:
  explicit FileFrame(const Scene& scene)
      : unit_(std::ldexp(1.0, scene.unit_exponent())),
        frame_(scene.problem().file_frame.value_or(FramePose{})) {}

  VectorForm point(const VectorForm& forms) const {
    VectorForm result = turned(forms, unit_);
    for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)].constant.value += frame_.origin[i];
    return result;
  }
  VectorForm direction(const VectorForm& forms) const { return turned(forms, 1); }
  /// normal·axesᵀx = offset
  PlaneForms plane(const PlaneForms& plane) const {
    PlaneForms result{direction(plane.normal), {}};
    Combination offset;
    offset.plus(unit_, plane.offset);
    for (int i = 0; i < 3; ++i)
      if (frame_.origin[i] != 0) offset.plus(frame_.origin[i], result.normal[static_cast<std::size_t>(i)]);
    result.offset = offset.form();
    return result;
  }

 private:
  VectorForm turned(const VectorForm& forms, double factor) const {
    VectorForm result;
    for (int i = 0; i < 3; ++i) {
      Combination sum;
      for (int j = 0; j < 3; ++j)
        if (frame_.axes(j, i) != 0) sum.plus(factor * frame_.axes(j, i), forms[static_cast<std::size_t>(j)]);
      result[static_cast<std::size_t>(i)] = sum.form();
    }
    return result;
  }

  double unit_;
  FramePose frame_;
};

}  // namespace

SceneForms scene_forms(const Scene& scene, const SceneEquations& equations) {
  const ProblemStatement& problem = scene.problem();
  const SceneSystem* general = equations.general();
  const DistanceForms distances(scene, equations);
  SceneForms forms;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_point(entity))
      forms.points.push_back(general ? general->elements().point(entity) : distances.point(entity));
    else if (problem.is_line(entity))
      forms.lines.push_back(general ? general->elements().line(entity)
                                    : distances.line(problem.line_of(entity)));
    else
      forms.planes.push_back(general->elements().plane(entity));
  return forms;
}

LinearForm substituted(const LinearForm& form, const std::map<int, LinearForm>& replaced) {
  Combination sum;
  sum.plus(rounded_to_double(form.constant).real());
  for (const ScaledUnknown& term : form.terms) {
    const auto found = replaced.find(term.unknown);
    sum.plus(rounded_to_double(term.coefficient).real(),
             found == replaced.end() ? LinearForm{{{term.unknown}}, {}} : found->second);
  }
  return sum.form();
}

SceneForms in_file(const SceneForms& forms, const Scene& scene) {
  const FileFrame file(scene);
  SceneForms result;
  for (const VectorForm& point : forms.points) result.points.push_back(file.point(point));
  for (const LineForms& line : forms.lines)
    result.lines.push_back({file.point(line.foot), file.direction(line.direction)});
  for (const PlaneForms& plane : forms.planes) result.planes.push_back(file.plane(plane));
  return result;
}

}  // namespace gcs
