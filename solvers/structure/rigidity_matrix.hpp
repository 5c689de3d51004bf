#pragma once
/// The rigidity matrix of a problem at a random placement over a prime field: exact, without square roots.

#include <random>
#include <vector>

#include "solvers/numeric/prime_field.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Where an entity is, or how fast it moves. `direction` is used by lines only.
struct ResiduePlacement {
  Residue3 point;
  Residue3 direction;
};

/// A free point has d columns, a free line six (a point on it and a direction), a fixed entity none.
struct RigidityMatrix {
  int dimension = 3;
  int point_count = 0;
  int columns = 0;
  std::vector<int> first_column;            ///< one per entity; −1: fixed
  std::vector<ResiduePlacement> placement;  ///< one per entity
  ResidueMatrix rows;  ///< one per constraint: a non-zero multiple of its distance's gradient
  /// Motions that change no distance whatever the constraints: the rigid motions that leave the fixed
  /// entities where they are, and of every free line the sliding of its point along it and the stretching of
  /// its direction.
  ResidueMatrix trivial_motions;
};

/// The matrix at a placement drawn from `engine`. Fixed entities are placed at random too: what is asked is
/// how the problem behaves at almost all placements.
RigidityMatrix rigidity_matrix(const ProblemStatement& problem, std::mt19937_64& engine);

/// For every entity, linear equations in the d(d+1)/2 coordinates of a rigid motion and one last coordinate
/// 1: they hold when that motion moves the entity as `velocity` (one entry per column of the matrix) does.
std::vector<ResidueMatrix> rigid_motion_equations(const RigidityMatrix& matrix,
                                                  const ResidueVector& velocity);

}  // namespace gcs
