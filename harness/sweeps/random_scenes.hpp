#pragma once
/// Random point distance problems for checks that need many of them: generically rigid graphs with a sketch,
/// lengths that a figure has, and an interpolation. The same seed gives the same problem everywhere.

#include <cstdint>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct SceneKind {
  int dimension = 2;  ///< 2 or 3
  int points = 4;     ///< at least the dimension
};

/// 4 to 10 points in the plane and in space.
inline constexpr int scene_kind_count = 14;

/// Consecutive seeds go through all kinds in turn.
SceneKind random_scene_kind(std::uint64_t seed);

/// The graph grows from an edge (2D) or a triangle (3D) by Henneberg steps, which keep it generically rigid:
/// type I hangs a point on d others; type II removes an edge and joins a point to its ends and d − 1 others,
/// preferably such as hang on d points only, so that few points can be placed one by one. Sketch and target
/// are placements in a box of random size (1e-3 to 1e3): independent ones for one scene in four; for the
/// others the target is a half, a quarter or an eighth of the way from the sketch to an independent
/// placement, because from a far sketch S often turns before the target. The bent constraint is random, and
/// the bend is twice the size of the box. Throws std::logic_error when the result is not well posed.
ProblemStatement random_problem(const SceneKind& kind, std::uint64_t seed);

/// The same with the lengths that the sketch has.
ProblemStatement random_problem_of_sketch(const SceneKind& kind, std::uint64_t seed);

}  // namespace gcs
