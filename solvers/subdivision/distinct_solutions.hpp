#pragma once
/// Which of the solutions that a subdivision proves are the same, or mirror images of each other.

#include <vector>

#include "solvers/certificates/krawczyk_test.hpp"

namespace gcs {

/// The unknowns' signs, each 1 or −1, that lead from a solution to others of its class.
std::vector<Eigen::VectorXd> mirror_signs(const SignMasks& mirror);

struct DistinctSolutions {
  std::vector<ProvenSolution> list;  ///< proven to be of different classes
  std::vector<Box> undecided;  ///< those that are not proven to be of the class of one listed, or not to be
};

/// A solution is the one listed where a mirror image of its enclosure lies where that is the only one, and
/// another one where all miss the listed one's enclosure. `mirror`: see QuadraticSystem.
DistinctSolutions distinct_solutions(const std::vector<ProvenSolution>& found, const SignMasks& mirror);

}  // namespace gcs
