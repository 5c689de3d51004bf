#pragma once
/// Lengths as the file gives them, exactly.

#include "solvers/model/problem.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {

/// The squared length of the constraint, in the file's unit.
Rational exact_square(const DistanceConstraint& constraint);

}  // namespace gcs
