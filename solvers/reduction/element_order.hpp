#pragma once
/// In which order the elements of a general scene can be placed one by one, whatever their kinds are, after what has to
/// be solved first.

#include <optional>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {

/// An element that hangs on elements placed before it: as many equations as unknowns are left when these are known.
struct PlacingStep {
  int entity = -1;
  std::vector<int> unknowns;   ///< of the element, and those that its constraints bring along
  std::vector<int> equations;  ///< as many
  std::vector<int> after;      ///< the steps on whose choice these depend, ascending
};

/// What a scene consists of when elements that can be placed after the others are taken away. The equations are those
/// of `scene`, the given one in a frame of the core's.
struct ElementOrder {
  Scene scene;
  std::vector<bool> is_in_core;  ///< of each entity
  std::vector<PlacingStep> steps;
  SubProblem core;
  bool core_is_given = false;  ///< there is nothing to be solved in it
};

/// Nothing where no element can be placed after others, or where it is not known how solutions of the core are
/// counted in the whole: where signs are stated, and where without the other elements more figures are one
/// solution (a plane loses its side). Points that hang on points of the core stay in it: see decompose.
std::optional<ElementOrder> element_order(const Scene& scene);

}  // namespace gcs
