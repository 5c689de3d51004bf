#include "harness/descriptions/unknown_names.hpp"

#include <fmt/format.h>

#include <string_view>

#include "harness/descriptions/scene_forms.hpp"

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

void name_elements(const ProblemStatement& problem, const SceneForms& forms, Names& names) {
  for (std::size_t i = 0; i < forms.points.size(); ++i) names.set(forms.points[i], problem.points[i] + "_");
  for (std::size_t i = 0; i < forms.lines.size(); ++i) {
    names.set(forms.lines[i].foot, problem.lines[i] + "_");
    names.set(forms.lines[i].direction, problem.lines[i] + "_u");
  }
  for (std::size_t i = 0; i < forms.planes.size(); ++i) {
    names.set(forms.planes[i].normal, problem.planes[i] + "_n");
    names.set(unknown_of(forms.planes[i].offset), problem.planes[i] + "_h");
  }
}

}  // namespace

std::vector<std::string> unknown_names(const Scene& scene, const SceneEquations& equations) {
  Names names(equations.system().unknowns);
  // First, since a point of a body may be its origin.
  if (const SceneSystem* general = equations.general())
    for (const NamedVector& vector : general->elements().named()) names.set(vector.forms, vector.name);
  name_elements(scene.problem(), scene_forms(scene, equations), names);
  return names.finish();
}

}  // namespace gcs
