#pragma once
/// What a constraint gives: a length, an angle, a sign.

#include "solvers/reading/instance_format.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads `length` or `squared` of a distance, `degrees` or `cosine` of an angle, and `sign` of an orientation into the
/// relation; others give nothing. Precondition: its type and operands are read.
void read_value(const JsonCursor& constraint, InstanceFormat format, const ProblemStatement& problem,
                Relation& relation);

}  // namespace gcs
