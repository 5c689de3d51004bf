#pragma once
/// Where the elements of a scene are, as linear forms in the unknowns of its equations.

#include <map>
#include <vector>

#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

/// In the order of the problem's elements.
struct SceneForms {
  std::vector<VectorForm> points;
  std::vector<LineForms> lines;
  std::vector<PlaneForms> planes;
};

/// In the scene's frame and unit.
SceneForms scene_forms(const Scene& scene, const SceneEquations& equations);

/// With forms in the place of unknowns, in doubles.
LinearForm substituted(const LinearForm& form, const std::map<int, LinearForm>& replaced);

/// From there to the frame and unit of the scene's file, in doubles.
SceneForms in_file(const SceneForms& forms, const Scene& scene);

}  // namespace gcs
