#pragma once
/// The parts of an instance that tell a solver how to go about it:
/// `reference`, `interpolation` and `construction`.

#include "solvers/problem/problem_statement.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads `reference` into the problem: origin, axis and in space plane, or a line and a height, or a body.
/// Precondition: entities are read.
void read_reference(const JsonCursor& reference, ProblemStatement& problem);

/// Reads `interpolation`. Precondition: constraints and the sketch are read.
InterpolationChoice read_interpolation(const JsonCursor& interpolation, const ProblemStatement& problem);

/// Reads `construction`; the result places every point that is not fixed. A file may leave out the first
/// point, and with a `reference` all of its points where they are pairwise constrained: they are added.
/// Precondition: all but the other hints is read, and the problem's reference too.
std::vector<PlanStep> read_construction(const JsonCursor& construction, const ProblemStatement& problem);

}  // namespace gcs
