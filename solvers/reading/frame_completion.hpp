#pragma once
/// What else a frame is put in where `fixed` leaves motions.

#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Puts the frame in the fixed elements and, where these leave motions, in the body that has them all, or in others that
/// use up the motions; refused where there are none, with what to fix. Where they leave none nothing is changed.
/// Precondition: of gcsbench-instance/2 all but the hints is read.
void complete_frame(const JsonCursor& fixed, ProblemStatement& problem);

}  // namespace gcs
