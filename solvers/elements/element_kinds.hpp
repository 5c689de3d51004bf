#pragma once
/// The kinds of elements, a file for each: unknowns, their normalisation, and how they follow from a placement.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solvers/elements/system_builder.hpp"

namespace gcs {

/// A line by its point f nearest to the origin and its direction u: u·u = 1, f·u = 0.
LineForms free_line(SystemBuilder& builder, SignMask turning,
                    const std::function<ComplexLine(const Placement&)>& where);
/// A line beyond those of the scene; its unknowns are found by two of the points that it is to go through.
LineForms further_line(SystemBuilder& builder, const std::vector<int>& through);
/// The line of that number, whose direction is that of another element: f·u = 0.
LineForms line_along(SystemBuilder& builder, const VectorForm& direction, SignMask turning, int line);
/// f + λ u = p. The unknown λ has the sign of the direction.
void state_on_line(SystemBuilder& builder, const VectorForm& point, const LineForms& line,
                   int value = no_value);
/// v = s u for two directions of length 1, so that s = ±1.
void state_same_direction(SystemBuilder& builder, const VectorForm& v, const VectorForm& u);
/// The lines, itself among them, that the problem says are parallel to a line, by their numbers.
std::vector<int> parallel_lines(const ProblemStatement& problem, int line);
/// The planes that are perpendicular to one of these lines.
std::vector<int> planes_across(const ProblemStatement& problem, const std::vector<int>& lines);

/// A plane by its unit normal and its offset.
PlaneForms free_plane(SystemBuilder& builder, SignMask turning,
                      const std::function<ComplexPlane(const Placement&)>& where);

/// The plane of that number, whose normal is that direction or, where it is open which way it goes, that or the opposite
/// one: m = s n, s·s = 1. `turning`: of the direction.
PlaneForms plane_across(SystemBuilder& builder, const VectorForm& direction, SignMask turning,
                        bool is_either_way, int plane);

/// A plane beyond those of the scene; its unknowns are found by three of the points that it is to go through.
PlaneForms further_plane(SystemBuilder& builder, const std::vector<int>& through);

/// Why a body's pose cannot be told from its elements, in a sentence; nothing where it can. In a unit of 2^−exponent of the
/// file's no product of two lengths under- or overflows.
std::optional<std::string> why_no_pose(const ProblemStatement& problem, const RigidBody& body, int exponent);

/// From one point of a body to another or, without that, of a line or along the normal of a plane.
struct BodyDirection {
  int from = -1, to = -1;
};

/// A body by the place t of its origin and the images e, f, g of its axes: e·e = f·f = 1, e·f = 0, g = e × f. Each
/// posture once, half-turns included. g is left out where all points have a last coordinate of 0; in the plane
/// e·e = 1, and f is e turned by a right angle. A body with a point that has its place, `joint`, has its origin there, and
/// no t.
PlacedBody free_body(SystemBuilder& builder, const RigidBody& body, std::optional<int> joint,
                     const std::vector<BodyDirection>& directions);
/// The same at t = 0 with the axes of the frame.
PlacedBody body_at_rest(SystemBuilder& builder, const RigidBody& body,
                        const std::vector<BodyDirection>& directions);

/// Where a body has directions in common with others before it.
struct HingedPose {
  /// A direction, and where it is in the body.
  struct Axis {
    BodyDirection in_body;
    VectorForm direction;
  };
  int origin = -1;  ///< a point of the body, or a line by the point that the file gives
  VectorForm at;    ///< its place
  Axis first;
  /// One that is not parallel to the first.
  std::optional<Axis> second;
  bool is_turned = false;  ///< whether the two have their angle anyway
};

/// A body by the direction u of its hinge and another one, w, of its own: w·w = 1 and u·w as in the body; a third vector
/// is u × w, where the body has it. A second hinge takes the place of w, and then u·w closes a loop, unless the body
/// `is_turned`. w is the first of `directions` that is not parallel to u, if there is one.
PlacedBody hinged_body(SystemBuilder& builder, const RigidBody& body, const HingedPose& pose,
                       const std::vector<BodyDirection>& directions);

}  // namespace gcs
