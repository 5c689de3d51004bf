#pragma once
/// Which part of an under-constrained problem moves against the rest.

#include <random>
#include <vector>

#include "solvers/structure/rigidity_matrix.hpp"

namespace gcs {

/// The entities outside the body: the fixed entities and all that stays with them, or where nothing is fixed
/// the largest set of entities that every motion of the problem moves rigidly together.
/// Empty when all is rigid.
std::vector<int> loose_entities(const RigidityMatrix& matrix, std::mt19937_64& engine);

}  // namespace gcs
