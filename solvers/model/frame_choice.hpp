#pragma once
/// Which elements of a problem its frame is put in.

#include <array>
#include <optional>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// The program's choice, without given positions. −1 for what a general scene does not have.
Reference default_reference(const ProblemStatement& problem);

/// The frame of the first line: it is the x-axis, and the first point that is constrained against it at a
/// distance > 0 is on the z-axis. Precondition: there is a line.
Reference line_reference(const ProblemStatement& problem);

/// Which given elements tell where the frame is that their motions are seen in: those that leave all of them in place. Such
/// motions are all turns about a point, or turns about an axis and shifts across it (of planes across it), or turns about
/// an axis and shifts along it (of a line), or one of the two alone.
struct GivenAxis {
  int origin = -1;  ///< a point
  int line = -1;    ///< where there is no point: the line that the origin is on
  int axis = -1;    ///< another point, or else a plane across the first axis, or else a line along it
  /// Of a shift alone, which is along the first axis: what the second axis is along, the normal of a plane or the way from
  /// `line` to another one, and what lies on the positive side of the third.
  std::array<int, 2> across{-1, -1};

  bool leaves_shift() const { return across[0] >= 0; }
  bool leaves_turn_about_line() const { return line >= 0 && axis >= 0 && axis != line; }
};

/// Given elements, which stay where they are, and others that use up the motions left by these (see Reference); nothing where
/// the problem has no such elements beside its bodies. Of a shift, or a turn about a line, alone there is neither origin nor
/// axis: all given elements are in place, and `height` has the first coordinate 0 (of a line its foot, of a plane where it
/// meets the first axis), or `plane` is in the xy-plane, or its direction or normal.
std::optional<Reference> completing_reference(const ProblemStatement& problem, const GivenAxis& given);

/// Whether the frame makes that coordinate of a point 0.
bool is_zero_in_frame(const ProblemStatement& problem, const Reference& reference, int point, int axis);

/// Whether a given element stays where the frame has it. Where positions leave motions and say no more than where the
/// whole is, `reference` may be another frame.
bool rests_in_frame(const ProblemStatement& problem, int entity);

}  // namespace gcs
