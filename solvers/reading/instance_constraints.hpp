#pragma once
/// The part of an instance that says what is to hold: `constraints`.

#include "solvers/reading/instance_format.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads `constraints` into the problem: distances between points, and in space of points from lines, as such, the rest
/// as relations. Refused: ids that are taken, two constraints that say the same, and distances that only parallel
/// elements have between elements that no `parallel` joins. Precondition: entities, bodies and `fixed` are read.
void read_constraints(const JsonCursor& list, InstanceFormat format, ProblemStatement& problem);

}  // namespace gcs
