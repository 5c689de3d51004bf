#pragma once
/// The interpretation tree of a construction plan, [I] §2.3.2: every way to choose between the two intersections
/// of each instruction, evaluated.

#include <vector>

#include "solvers/construction/plan.hpp"

namespace gcs {

/// How the spheres (circles in the plane) of an instruction meet, for one choice in all instructions before it.
enum class Meeting {
  framed,      ///< where the frame says: the other intersection is the same figure turned
  two_points,  ///< each is a node of its own
  touching,    ///< in one point, to rounding
  apart,       ///< nowhere
  undefined    ///< nowhere or in a whole circle: their centres are one or, in space, on one line, to rounding
};

/// A choice in all instructions up to one.
struct InterpretationNode {
  int parent = -1;       ///< its number in the tree; −1: the root, which is before the first instruction
  int instruction = -1;  ///< the last one evaluated
  int side = 0;          ///< b_i of that instruction, +1 or −1; 0 where there are not two intersections
  Meeting meeting = Meeting::framed;
  bool is_on_branch = true;  ///< of the plan: its instructions' sides
  Eigen::Matrix3Xd points;   ///< those placed so far, one column each

  /// Whether the branch ends here, without a point.
  bool has_ended() const { return meeting == Meeting::apart || meeting == Meeting::undefined; }
};

/// Of a scene, in the plan's frame and the scene's unit.
struct InterpretationTree {
  Plan plan;
  std::vector<double> driven;             ///< values of the driving parameters
  std::vector<InterpretationNode> nodes;  ///< level by level, the root first, children by b_i = +1, −1

  /// Numbers of the nodes at which all points are placed, in their order.
  std::vector<int> figures() const;
};

/// How many instructions choose between two intersections. The others are those of the frame.
int choices(const Plan& plan);

/// The tree with these radii, `lengths` of the constraints of the scene, in its unit. Driving parameters, and the
/// branch that is marked, are those of `sketch`, a figure in the scene's unit in any position. The tree has up
/// to 2^choices(plan) figures. Precondition: the plan is one of this scene, its copies of points where the
/// sketch has them.
InterpretationTree interpretation_tree(const Scene& scene, Plan plan, const Figure& sketch,
                                       const std::vector<double>& lengths);

}  // namespace gcs
