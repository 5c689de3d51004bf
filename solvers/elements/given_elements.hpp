#pragma once
/// Elements with given positions as what they are to the rest: a body that does not move.

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Those that have given positions, with the numbers of the file.
std::vector<BodyElement> given_elements(const ProblemStatement& problem);

/// The problem with these as a further body, the last, which the frame is put in; a body that has no others is empty.
/// Where there are none, the problem.
ProblemStatement with_given_body(ProblemStatement problem);

/// Whether a scene is solved by the equations of all kinds of elements: those of squared lengths do not know given lines.
bool has_element_equations(const ProblemStatement& problem);

}  // namespace gcs
