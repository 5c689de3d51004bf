#include "harness/descriptions/unknown_names.hpp"

#include <fmt/format.h>

#include <string_view>

namespace gcs {
namespace {

constexpr std::string_view axes = "xyz";

/// The unknown that a form is; −1: it is none.
int unknown_of(const LinearForm& form) {
  if (form.terms.size() != 1 || !form.constant.is_zero()) return -1;
  const ExactNumber& coefficient = form.terms.front().coefficient;
  const bool is_one = coefficient.decimal.empty() && rounded_to_double(coefficient) == 1.0;
  return is_one ? form.terms.front().unknown : -1;
}

class Names {
 public:
  explicit Names(int unknowns) : names_(static_cast<std::size_t>(unknowns)) {}

  /// Nothing for an unknown that has a name, or for −1.
  void set(int unknown, std::string name) {
    if (unknown < 0) return;
    std::string& here = names_[static_cast<std::size_t>(unknown)];
    if (here.empty()) here = std::move(name);
  }

  void set(const VectorForm& forms, const std::string& prefix) {
    for (std::size_t axis = 0; axis < 3; ++axis) set(unknown_of(forms[axis]), prefix + axes[axis]);
  }

  std::vector<std::string> finish() {
    int next = 1;
    for (std::string& name : names_)
      if (name.empty()) name = fmt::format("u{}", next++);
    return std::move(names_);
  }

 private:
  std::vector<std::string> names_;
};

void name_general(const SystemBuilder& forms, Names& names) {
  const ProblemStatement& problem = forms.problem();
  // First, since a point of a body may be its origin.
  for (const NamedVector& vector : forms.named()) names.set(vector.forms, vector.name);
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    const std::string& name = problem.name(entity);
    if (problem.is_point(entity)) {
      names.set(forms.point(entity), name + "_");
    } else if (problem.is_line(entity)) {
      names.set(forms.line(entity).foot, name + "_");
      names.set(forms.line(entity).direction, name + "_u");
    } else {
      names.set(forms.plane(entity).normal, name + "_n");
      names.set(unknown_of(forms.plane(entity).offset), name + "_h");
    }
  }
}

void name_distances(const ProblemStatement& problem, const SceneEquations& equations, Names& names) {
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
    for (int axis = 0; axis < problem.dimension; ++axis)
      names.set(equations.point_unknown(point, axis),
                fmt::format("{}_{}", problem.name(point), axes[static_cast<std::size_t>(axis)]));
  constexpr std::array<std::string_view, 3> parts{"", "u", "m"};
  for (int line = 0; line < static_cast<int>(problem.lines.size()); ++line)
    for (int part = 0; part < 3; ++part)
      for (int axis = 0; axis < 3; ++axis)
        names.set(equations.line_unknown(line, part, axis),
                  fmt::format("{}_{}{}", problem.lines[static_cast<std::size_t>(line)],
                              parts[static_cast<std::size_t>(part)], axes[static_cast<std::size_t>(axis)]));
}

}  // namespace

std::vector<std::string> unknown_names(const Scene& scene, const SceneEquations& equations) {
  Names names(equations.system().unknowns);
  if (const SceneSystem* general = equations.general())
    name_general(general->elements(), names);
  else
    name_distances(scene.problem(), equations, names);
  return names.finish();
}

}  // namespace gcs
