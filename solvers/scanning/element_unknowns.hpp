#pragma once
/// How the unknowns of a general scene's equations follow from its elements, as a plan places them one by one, and which
/// equations are left to be checked.

#include <string>
#include <vector>

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/construction/element_plan.hpp"
#include "solvers/elements/scene_system.hpp"

namespace gcs {

/// A component of an element.
struct UnknownOfElement {
  enum class Part { point, foot, direction, normal, offset };

  int unknown = -1;
  int entity = -1;
  Part part = Part::point;
  int axis = 0;
  bool is_opposite = false;
};

/// The only one in these equations that is not known before, and not in products with itself.
struct UnknownOfEquations {
  int unknown = -1;
  std::vector<int> equations;
};

/// The way from one point to another: its length, which is positive where it is not known before, and its direction.
struct UnknownsOfSegment {
  int from = -1, to = -1;
  int length = -1;
  bool is_length_known = false;
  std::vector<int> direction;  ///< by axis
};

/// What is known once an element is placed.
struct KnownAtStep {
  std::vector<UnknownOfElement> of_elements;
  std::vector<UnknownsOfSegment> of_segments;
  std::vector<UnknownOfEquations> of_equations;
  std::vector<int> checks;  ///< equations of constraints that the plan does not use to place
};

struct ElementUnknowns {
  KnownAtStep at_rest;             ///< before the first step
  std::vector<int> resting;        ///< entities whose position is given in the frame
  std::vector<KnownAtStep> steps;  ///< of each step of the plan
  std::vector<int> missing;        ///< equations with unknowns that do not follow
};

/// `equations`: those of the system, which stands in the plan's frame.
ElementUnknowns element_unknowns(const SceneSystem& system, const IntervalEquations& equations,
                                 const ElementPlan& plan);

}  // namespace gcs
