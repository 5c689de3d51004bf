#pragma once
/// In which order the poses of bodies follow from each other by what they share.

#include <optional>
#include <string>
#include <vector>

#include "solvers/elements/element_kinds.hpp"

namespace gcs {

/// How the pose of one body follows from those of bodies before it.
struct BodyStep {
  /// A direction that several bodies have: axes[number], or the opposite one; or either way that of a line or a plane.
  struct Use {
    int axis = -1;
    bool is_opposite = false;
    BodyDirection in_body;
    int along = -1;     ///< the line or plane, of a body before it; −1: axes[number]
    int relation = -1;  ///< which gives it; −1: what the body shares
    int joint = -1;     ///< its number among body_joints
  };
  int body = -1;
  /// Directions that it has in common with bodies before it and that are not parallel, at most two.
  std::vector<Use> known;
  /// A point, or else a line, of bodies before it, on the first joint where that has one; −1: none.
  int origin = -1;
  /// Points, lines and planes of bodies before it whose place needs no equation.
  std::vector<int> implied;
  /// Lines whose direction needs none.
  std::vector<int> directed;
  std::vector<int> further;  ///< the axes that it gives to bodies after it

  /// Whether one joint gives both directions.
  bool is_turned() const { return known.size() == 2 && known[0].joint == known[1].joint; }
};

struct BodyOrder {
  std::vector<BodyStep> steps;      ///< one per body, that at rest first
  std::vector<BodyDirection> axes;  ///< in the body that gives it
  std::string reason;               ///< why there are no equations for these joints; empty: there are
};

/// At rest is the body that the frame is put in. A step takes a body that has a direction in common with one before it,
/// where there is one, otherwise one with a point of those before: first those that would close a loop badly, since they
/// have parallel directions or more than two.
BodyOrder body_order(const ProblemStatement& problem);

}  // namespace gcs
