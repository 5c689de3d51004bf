#pragma once
/// Equations with fewer solutions to find and fewer monomials, for solvers that follow as many paths as their mixed volume.

#include <map>

#include "solvers/model/quadratic_system.hpp"

namespace gcs {

struct ReducedSystem {
  QuadraticSystem system;              ///< unknowns keep their numbers
  std::map<int, LinearForm> replaced;  ///< the unknowns that it has no more, in terms of the others
};

/// After Gaussian elimination of the monomials (polyhedral/eliminated_equations.hpp), in doubles. An unknown of each
/// linear equation is replaced by what that says, and one of which an equation gives the square by the positive root, where the
/// sign is one that `mirror` leaves open: of solutions that are not counted apart one is left, or more. Precondition: the
/// equations are independent.
ReducedSystem reduced_system(const QuadraticSystem& system);

}  // namespace gcs
