#pragma once
/// What of a scene can be solved apart, and in which order elements and bodies can be placed one by one on that, whatever
/// their kinds are.

#include <optional>
#include <vector>

#include "solvers/elements/placing_steps.hpp"

namespace gcs {

/// A scene as steps: cores, of which each hangs on nothing but the frame, and what is placed one by one. The equations
/// are those of `scene`, the given one in a frame of the cores': a body, or points at given distances, that they share.
struct ElementOrder {
  Scene scene;
  std::vector<PlacingStep> steps;
};

/// Of all frames that of most cores, where there are two or more; otherwise, one core and what hangs on it, that of the
/// smallest one. Nothing where that is one core or a single step, or where it is not known how solutions of a core are
/// counted in the whole: where signs are stated, where several given positions leave motions, and where without the other elements more figures are one solution (a
/// plane loses its side). Points that hang on points of a core without more than distances stay in it: see decompose.
std::optional<ElementOrder> element_order(const Scene& scene);

}  // namespace gcs
