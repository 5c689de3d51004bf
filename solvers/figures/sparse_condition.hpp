#pragma once
/// Condition numbers of large Jacobians, which have few entries in a row.

#include "solvers/model/scene.hpp"

namespace gcs {

/// The condition number that jacobian_condition stands for, from below: the extreme singular values by forty
/// steps of the power method with JᴴJ and with its inverse, by sparse LU factors. In general right to a few
/// per cent. Infinite where the factorisation breaks down. Precondition: no lines.
double sparse_jacobian_condition(const Scene& scene, const Figure& figure);

}  // namespace gcs
