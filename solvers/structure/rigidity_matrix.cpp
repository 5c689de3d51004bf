#include "solvers/structure/rigidity_matrix.hpp"

#include <span>

namespace gcs {
namespace {

/// A generator of the rigid motions: a translation or a rotation about an axis through the origin.
struct RigidMotion {
  Residue3 translation;
  Residue3 rotation;
};

std::vector<RigidMotion> rigid_motions(int dimension) {
  std::vector<RigidMotion> motions;
  for (int axis = 0; axis < dimension; ++axis) motions.emplace_back().translation[axis] = Residue(1);
  for (int axis = dimension == 2 ? 2 : 0; axis < 3; ++axis)
    motions.emplace_back().rotation[axis] = Residue(1);
  return motions;
}

ResiduePlacement velocity_under(const RigidMotion& motion, const ResiduePlacement& placement) {
  return {motion.translation + cross(motion.rotation, placement.point),
          cross(motion.rotation, placement.direction)};
}

Residue3 random_vector(int dimension, std::mt19937_64& engine) {
  Residue3 vector;
  for (int i = 0; i < dimension; ++i) vector[i] = Residue::random(engine);
  return vector;
}

bool is_line(const RigidityMatrix& matrix, int entity) { return entity >= matrix.point_count; }

void write(ResidueVector& row, int first, int count, const Residue3& value) {
  if (first < 0) return;
  for (int i = 0; i < count; ++i) row[first + i] = value[i];
}

/// Half the gradient of |p − q|².
ResidueVector point_point_row(const RigidityMatrix& matrix, int p, int q) {
  ResidueVector row(matrix.columns);
  const Residue3 difference = matrix.placement[p].point - matrix.placement[q].point;
  write(row, matrix.first_column[p], matrix.dimension, difference);
  write(row, matrix.first_column[q], matrix.dimension, Residue3{} - difference);
  return row;
}

/// With w = p − q, s = w·u, N = u·u and v = N w − s u, the squared distance to the line q + R u is
/// w·w − s²/N, and N²/2 times its gradient is N v for p, −N v for q and −s v for u.
ResidueVector point_line_row(const RigidityMatrix& matrix, int point, int line) {
  ResidueVector row(matrix.columns);
  const Residue3& u = matrix.placement[line].direction;
  const Residue3 w = matrix.placement[point].point - matrix.placement[line].point;
  const Residue s = dot(w, u);
  const Residue n = dot(u, u);
  const Residue3 v = n * w - s * u;
  write(row, matrix.first_column[point], 3, n * v);
  if (const int first = matrix.first_column[line]; first >= 0) {
    write(row, first, 3, -n * v);
    write(row, first + 3, 3, -s * v);
  }
  return row;
}

/// Equations in the motion's coordinates and one more: the motion moves the entity with the given velocity. A
/// line moves the same when the differences of both velocities are parallel to it.
ResidueMatrix motion_equations(const RigidityMatrix& matrix, std::span<const RigidMotion> motions, int entity,
                               const ResiduePlacement& velocity) {
  const ResiduePlacement& placement = matrix.placement[entity];
  const bool line = is_line(matrix, entity);
  ResidueMatrix equations(line ? 6 : matrix.dimension, ResidueVector(motions.size() + 1));
  const auto set_column = [&](std::size_t column, const ResiduePlacement& value) {
    const Residue3 first = line ? cross(value.point, placement.direction) : value.point;
    const Residue3 second = cross(value.direction, placement.direction);
    for (std::size_t i = 0; i < equations.size(); ++i)
      equations[i][column] = i < 3 ? first[i] : second[i - 3];
  };
  for (std::size_t g = 0; g < motions.size(); ++g) set_column(g, velocity_under(motions[g], placement));
  set_column(motions.size(), {Residue3{} - velocity.point, Residue3{} - velocity.direction});
  return equations;
}

ResiduePlacement velocity_of(const RigidityMatrix& matrix, int entity, const ResidueVector& velocity) {
  ResiduePlacement result;
  const int first = matrix.first_column[entity];
  if (first < 0) return result;
  const bool line = is_line(matrix, entity);
  for (int i = 0; i < (line ? 3 : matrix.dimension); ++i) {
    result.point[i] = velocity[first + i];
    if (line) result.direction[i] = velocity[first + 3 + i];
  }
  return result;
}

ResidueVector whole_velocity(const RigidityMatrix& matrix, const RigidMotion& motion) {
  ResidueVector result(matrix.columns);
  for (int entity = 0; entity < static_cast<int>(matrix.placement.size()); ++entity) {
    const int first = matrix.first_column[entity];
    const ResiduePlacement velocity = velocity_under(motion, matrix.placement[entity]);
    write(result, first, is_line(matrix, entity) ? 3 : matrix.dimension, velocity.point);
    if (first >= 0 && is_line(matrix, entity)) write(result, first + 3, 3, velocity.direction);
  }
  return result;
}

/// Coordinates, in the given generators, of the rigid motions that leave the fixed entities where they are.
ResidueMatrix motions_left_by_fixed(const RigidityMatrix& matrix, std::span<const RigidMotion> motions) {
  ResidueMatrix conditions;
  for (int entity = 0; entity < static_cast<int>(matrix.placement.size()); ++entity) {
    if (matrix.first_column[entity] >= 0) continue;
    for (ResidueVector& equation : motion_equations(matrix, motions, entity, {})) {
      equation.pop_back();  // the velocity is zero
      conditions.push_back(std::move(equation));
    }
  }
  return null_space(std::move(conditions), static_cast<int>(motions.size()));
}

ResidueMatrix trivial_motions(const RigidityMatrix& matrix) {
  const std::vector<RigidMotion> motions = rigid_motions(matrix.dimension);
  ResidueMatrix result;
  for (const ResidueVector& coordinates : motions_left_by_fixed(matrix, motions)) {
    RigidMotion motion;
    for (std::size_t g = 0; g < motions.size(); ++g) {
      motion.translation = motion.translation + coordinates[g] * motions[g].translation;
      motion.rotation = motion.rotation + coordinates[g] * motions[g].rotation;
    }
    result.push_back(whole_velocity(matrix, motion));
  }
  for (int entity = 0; entity < static_cast<int>(matrix.placement.size()); ++entity) {
    const int first = matrix.first_column[entity];
    if (first < 0 || !is_line(matrix, entity)) continue;
    for (const int part : {first, first + 3}) {
      result.emplace_back(matrix.columns);
      write(result.back(), part, 3, matrix.placement[entity].direction);
    }
  }
  return result;
}

void place_at_random(RigidityMatrix& matrix, const ProblemStatement& problem, std::mt19937_64& engine) {
  const int entities = static_cast<int>(problem.points.size() + problem.lines.size());
  for (int entity = 0; entity < entities; ++entity) {
    ResiduePlacement& placement = matrix.placement.emplace_back();
    placement.point = random_vector(matrix.dimension, engine);
    if (is_line(matrix, entity)) placement.direction = random_vector(matrix.dimension, engine);
    if (problem.is_fixed(entity)) {
      matrix.first_column.push_back(-1);
    } else {
      matrix.first_column.push_back(matrix.columns);
      matrix.columns += is_line(matrix, entity) ? 6 : matrix.dimension;
    }
  }
}

}  // namespace

RigidityMatrix rigidity_matrix(const ProblemStatement& problem, std::mt19937_64& engine) {
  RigidityMatrix matrix;
  matrix.dimension = problem.dimension;
  matrix.point_count = static_cast<int>(problem.points.size());
  place_at_random(matrix, problem, engine);
  for (const DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    if (!problem.is_point(a)) {
      matrix.rows.push_back(point_line_row(matrix, b, a));
    } else if (!problem.is_point(b)) {
      matrix.rows.push_back(point_line_row(matrix, a, b));
    } else {
      matrix.rows.push_back(point_point_row(matrix, a, b));
    }
  }
  matrix.trivial_motions = trivial_motions(matrix);
  return matrix;
}

std::vector<ResidueMatrix> rigid_motion_equations(const RigidityMatrix& matrix,
                                                  const ResidueVector& velocity) {
  const std::vector<RigidMotion> motions = rigid_motions(matrix.dimension);
  std::vector<ResidueMatrix> equations;
  for (int entity = 0; entity < static_cast<int>(matrix.placement.size()); ++entity) {
    equations.push_back(motion_equations(matrix, motions, entity, velocity_of(matrix, entity, velocity)));
  }
  return equations;
}

}  // namespace gcs
