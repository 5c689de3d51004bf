#pragma once
/// Which of the solutions that double precision found are the same, by how well each is conditioned.

#include <limits>

#include "solvers/figures/reflection_classes.hpp"

namespace gcs {

/// A candidate converged in double precision lies within u·condition of the exact solution, relative to the
/// scene's size (within a quarter of that on the stiff families), so two of the same class differ by twice
/// that at most; two solutions on both sides of a fold differ by a hundred times as much before they cannot
/// be told apart. No test is finer than 1e-10, which well-conditioned solutions of different classes never
/// come near, nor coarser than 1e-5, where different solutions would be merged.
double merging_tolerance(double condition);

struct SolutionAccuracy {
  double condition = 0;                                    ///< see jacobian_condition
  double error = std::numeric_limits<double>::infinity();  ///< see Candidate::error
};

/// Solutions up to a rigid motion and a reflection. Every one has its own tolerance: one coarse tolerance for
/// all would merge well-conditioned neighbours. Proven errors tell apart what condition numbers do not.
ReflectionClasses solution_classes(const Scene& scene, std::span<const Figure> representatives,
                                   std::span<const SolutionAccuracy> accuracies, int threads = 1);

}  // namespace gcs
