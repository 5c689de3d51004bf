#pragma once
/// How many solutions a square system of quadrics has at most, whatever its numbers are: a multihomogeneous Bézout bound,
/// which takes groups of unknowns together (Morgan, Sommese 1987).

#include <optional>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/numeric/natural.hpp"

namespace gcs {

/// The isolated solutions in Cⁿ together with their multiplicities. The system is divided into blocks of as many equations as
/// unknowns, each with unknowns of earlier blocks at most beside its own, and the bounds of the blocks are multiplied: an
/// isolated solution is one of each block. `groups`: of unknowns; those that are in none are groups of one. Those that meet
/// a block are joined, two by two, while its bound falls; it is Bézout's at most. Nothing where equations and unknowns
/// cannot be paired. Time: a fraction of a second for each block.
std::optional<Natural> system_bound(const QuadraticSystem& system,
                                    const std::vector<std::vector<int>>& groups);

/// The classes of isolated solutions up to the changes of signs, of which `first_turning` and later generators turn vectors
/// over. A class has as many solutions as there are changes unless one of these leaves its solutions where they are; none
/// does that turns a unit vector over. The Jacobian of such a solution falls apart into the equations and unknowns that keep
/// their signs and those that change them: where these are not as many the rank falls by c, the multiplicity is 2^c at
/// least, and the class counts no less. Changes of which this is not known do not divide the bound.
std::optional<Natural> class_bound(const QuadraticSystem& system,
                                   const std::vector<std::vector<int>>& groups);

/// Whether that is known of all of them.
bool divides_by_all(const QuadraticSystem& system);

/// Of a scene's equations, with the vectors of its elements as groups.
std::optional<Natural> class_bound(const SceneSystem& system);

}  // namespace gcs
