#pragma once
/// The parts of an instance that say where entities are: `fixed` and `sketch`.

#include "solvers/model/scene.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads `fixed` into the problem. Refused: two entities at the same place, and positions that leave the
/// figure movable as a whole, but for a line sought from four given points, for which this is no error of the
/// instance. Precondition: points and lines are read.
void read_fixed(const JsonCursor& fixed, ProblemStatement& problem);

/// A line is placed against fixed points or against free ones, and fixed points are not so far from the
/// origin that doubles do not hold the distances there. Precondition: constraints and `fixed` are read.
void check_fixed(const JsonCursor& fixed, const ProblemStatement& problem);

/// Reads `sketch` into the problem. Refused: a missing entity, a fixed one elsewhere, the two ends of a
/// constraint at the same place, and a flat sketch, where all distances are singular. Precondition: all but
/// the hints is read.
void read_sketch(const JsonCursor& sketch, ProblemStatement& problem);

/// The sketch must tell where the frame is. Precondition: the problem has a sketch.
void check_sketch_frame(const JsonCursor& sketch, const Scene& scene);

}  // namespace gcs
