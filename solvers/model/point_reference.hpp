#pragma once
/// The frame of a scene of points.

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Origin, axis and (in space) plane: the first that are pairwise constrained, in the order of the constraints, and by their
/// lengths not in a line. Three that are in all real solutions may in complex ones span a plane whose normal is one of its own
/// directions: in such a frame these are at infinity. Where there are no such three, the plane is any point that is not
/// constrained with both others.
Reference point_reference(const ProblemStatement& problem);

}  // namespace gcs
