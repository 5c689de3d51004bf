#pragma once
/// Which elements of a problem its frame is put in.

#include <optional>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// The program's choice, without given positions. −1 for what a general scene does not have.
Reference default_reference(const ProblemStatement& problem);

/// The frame of the first line: it is the x-axis, and the first point that is constrained against it at a
/// distance > 0 is on the z-axis. Precondition: there is a line.
Reference line_reference(const ProblemStatement& problem);

/// Given elements, which stay where they are, and others that use up the motions left by these: of a point, and of what
/// it has on an axis with it, the first are the origin and the axis; a line alone, or the first of parallel planes, is the
/// axis. Nothing where the problem has no elements beside its bodies that use up the motions. Preconditions: the given
/// elements are such, and leave motions.
std::optional<Reference> completing_reference(const ProblemStatement& problem);

/// Whether the frame makes that coordinate of a point 0.
bool is_zero_in_frame(const ProblemStatement& problem, const Reference& reference, int point, int axis);

/// The given elements that `completing_reference` puts the frame in; −1: none.
struct GivenAxis {
  int origin = -1;  ///< a point
  int axis = -1;    ///< another point, or else a plane, or else a line
};
GivenAxis given_axis(const ProblemStatement& problem);

/// Whether a given element stays where the frame has it. Where positions leave motions and say no more than where the
/// whole is, `reference` may be another frame.
bool rests_in_frame(const ProblemStatement& problem, int entity);

}  // namespace gcs
