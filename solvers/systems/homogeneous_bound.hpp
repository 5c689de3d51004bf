#pragma once
/// The multihomogeneous Bézout number: a bound on the number of isolated zeros in C^n, one for each way to put the
/// unknowns into groups. A. Morgan, A. Sommese: A homotopy for solving general polynomial systems that respects
/// m-homogeneous structures, Appl. Math. Comput. 24 (1987).

#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

/// The coefficient of Π_j α_j^(k_j) in Π_i Σ_j d_ij α_j, where d_ij is the degree of equation i in the k_j unknowns of
/// group j. `group_of`: of each unknown, from 0 on, none left out.
Natural homogeneous_bound(const Supports& supports, const std::vector<int>& group_of);

struct HomogeneousBound {
  Natural bound;
  std::vector<int> group_of;
};

/// The smallest one that a search finds which moves single unknowns and joins groups as long as the bound falls, from
/// all unknowns together and from each apart: maybe not the smallest of all, but a bound.
HomogeneousBound small_homogeneous_bound(const Supports& supports);

}  // namespace gcs
