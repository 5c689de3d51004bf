#pragma once
/// In which order the poses of bodies follow from each other, where two that share two points turn about a hinge.

#include <optional>
#include <string>
#include <vector>

#include "solvers/elements/element_kinds.hpp"

namespace gcs {

/// How the pose of one body follows from those of bodies before it.
struct BodyStep {
  /// A direction that several bodies have: axes[number], or the opposite one.
  struct Use {
    int axis = -1;
    bool is_opposite = false;
    BodyDirection in_body;
  };
  int body = -1;
  /// Hinges to bodies before it whose directions are not parallel, at most two.
  std::vector<Use> known;
  int origin = -1;  ///< a point on the first of them; where there is none, one of bodies before it, or −1
  std::vector<int>
      implied;  ///< points of bodies before it that need no equation, since they are on known hinges
  std::vector<int> further;  ///< the axes that it gives to bodies after it
};

struct BodyOrder {
  std::vector<BodyStep> steps;      ///< one per body, that at rest first
  std::vector<BodyDirection> axes;  ///< in the body that gives it
  std::string reason;               ///< why there are no equations for these hinges; empty: there are
};

/// At rest is the body that the frame is put in. A step takes a body that is hinged to one before it, where there is one, otherwise one with a point of those before:
/// first those that would close a loop badly, since they have parallel hinges or more than two.
BodyOrder body_order(const ProblemStatement& problem);

}  // namespace gcs
