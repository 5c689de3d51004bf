#pragma once
/// What subdivision leaves undecided where solutions lie too close together for it, decided by counting.
///
/// Boxes that are too small to be halved lie around a multiple solution, or a few simple ones. A polydisc that holds all of them
/// holds exactly d solutions, counted with multiplicities (ball_cluster.hpp); balls of many bits find and prove solutions there
/// (near_solutions.hpp, multiple_solution.hpp). Where a polydisc that holds these too has d, and they count for d, there is no
/// other one.

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// Boxes that are near each other, mirror images included.
struct UndecidedPlace {
  Box hull;                          ///< of them, or of their mirror images
  std::vector<std::size_t> members;  ///< their numbers
};

/// Boxes whose middles are within `reach` of the first one of a place, or of its mirror image, in every unknown.
/// `mirror`: see QuadraticSystem.
std::vector<UndecidedPlace> undecided_places(const std::vector<Box>& boxes, const SignMasks& mirror,
                                             double reach);

/// A real solution: simple, or a multiple one with fractions for unknowns.
struct CountedSolution {
  Box box;            ///< it is there
  double unique = 0;  ///< no other one is so near in all unknowns
  /// So many classes up to reflection meet there: of its own mirror image half of the solutions that it stands for.
  int multiplicity = 1;
};

/// All real solutions in a box, and maybe others beside it: proven to exist, no two of one class. Nothing where it is not
/// proven that these are all. Preconditions: as many equations as unknowns, unknowns of order 1, coefficients real.
std::optional<std::vector<CountedSolution>> real_solutions_in(const QuadraticSystem& system, const Box& box,
                                                              const std::stop_token& stop);

}  // namespace gcs
