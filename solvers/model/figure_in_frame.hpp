#pragma once
/// Figures as seen from other frames.

#include <optional>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// x ↦ axes·(x − origin), of figures real or not; lines keep the point that gives them.
Figure as_seen_from(const FramePose& frame, const Figure& figure);

/// Lines by their points nearest to the origin; the first component of a direction that is not 0 is positive.
Figure with_normalised_lines(Figure figure);

/// From the unit and frame of a scene to those of its file, 2^unit_exponent and `frame`, if there is one, and back. Without
/// a frame exactly, unless a number overflows or underflows.
Figure in_file(const Figure& figure, int unit_exponent, const std::optional<FramePose>& frame);
Figure in_scene(const Figure& figure, int unit_exponent, const std::optional<FramePose>& frame);

/// How far a figure is at most from another one in the file's frame, in the scene's unit, and its directions times `size`,
/// where in the scene's it is no further than `error`: the foot of a line and the offset of a plane also turn about the
/// file's origin.
double error_in_file(const Figure& figure, double error, double size, int unit_exponent,
                     const std::optional<FramePose>& frame);

}  // namespace gcs
