#pragma once
/// The parts of an instance that say where entities are: `fixed` and `sketch`.

#include "solvers/model/scene.hpp"
#include "solvers/reading/instance_format.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads `fixed` into the problem. Precondition: entities are read.
void read_fixed(const JsonCursor& fixed, ProblemStatement& problem);

/// Refused: two points at the same place.
void refuse_coincident_fixed_points(const JsonCursor& fixed, const ProblemStatement& problem);

/// Whether a line is sought by its distances from given points (4p1L). Wherever these are they make a question, to which
/// infinitely many lines or none may be the answer.
bool seeks_line_from_given_points(const ProblemStatement& problem);

/// Refused: two points at the same place, and positions that leave the figure movable as a whole, but for a line sought
/// from four given points, for which this is no error of the instance. Precondition: there are no planes.
void require_still(const JsonCursor& fixed, const ProblemStatement& problem);

/// A line is placed against fixed points or against free ones, and fixed points are not so far from the
/// origin that doubles do not hold the distances there. Precondition: constraints and `fixed` are read.
void check_fixed(const JsonCursor& fixed, const ProblemStatement& problem);

/// Reads `sketch` into the problem. In gcsbench-instance/2 it may leave out what is fixed, and elements of bodies whose
/// pose the others tell. Refused: a missing entity, a fixed one elsewhere, the two ends of a
/// distance at the same place, and a flat sketch of points and lines in space alone, where all distances are singular.
/// Precondition: all but the hints is read.
void read_sketch(const JsonCursor& sketch, InstanceFormat format, ProblemStatement& problem);

/// The sketch must tell where the frame is. Precondition: the problem has a sketch.
void check_sketch_frame(const JsonCursor& sketch, const Scene& scene);

}  // namespace gcs
