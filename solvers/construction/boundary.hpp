#pragma once
/// How far an instruction is from a boundary configuration (tangent circles or spheres), and where a
/// reference point should go to be far from one: [I] §4.2, §4.3.3, §6.

#include "solvers/construction/plan.hpp"

namespace gcs {

/// The measure γ of sphere `slot` of the instruction in a figure, in [0, 1]: slot 1 for interCC, interSSP and
/// interSS,
///   γ = dist(p, line(c0, c1)) / max(|p c0|, |p c1|),
/// slot 2 for interCS, γ = |p q| / max(|p c|, |p c2|) with c the circle's centre, and q the projection of p
/// on the line through c and the projection of c2 on the circle's plane. Where that line is undefined
/// (c0 = c1, or c2 on the circle's axis), γ is 0.
double boundary_measure(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points);

/// Not in [I]: the sine of the angle at which the spheres meet. γ does not see c0 → c1, where the
/// intersection is just as badly determined; the sine does. It is the factor that sphere `slot` contributes
/// to the determinant of the unit normals.
double crossing_sine(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points);

/// Where Algorithm 4 is followed as printed.
struct ShiftRule {
  /// For interCS the copy goes to the larger of the circle's radius and the sphere's, which can leave γ below
  /// α (r = 1, a_i6 = 12: γ = 1/√(1 + 12²) = 0.083); false: to the circle's radius, and γ ≥ 1/√2.
  bool larger_radius = false;
  /// The copy goes towards the projection of the point on the line, whatever the angle; false: at a right
  /// angle to the centre's direction where the projection is undefined, or so near to that direction that the
  /// spheres would touch (γ = 1/√2, sine = 1).
  bool towards_projection = false;
};

/// Algorithm 4: the fixed copy for sphere `slot` that puts γ above 1/√2, if it is not followed as printed.
/// Nothing where the printed text has no direction: the point lies on the line, or the line is undefined.
std::optional<Eigen::Vector3d> shifted_reference(const Instruction& instruction, int slot,
                                                 const Eigen::Matrix3Xd& points, const ShiftRule& rule = {});

}  // namespace gcs
