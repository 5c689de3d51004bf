#pragma once
/// Solutions of general scenes, counted by two homotopies.

#include <cstdint>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs::samples {

/// In how many classes the solutions of some answers and the figure, in the scene's unit, fall.
int classes_of(const Scene& scene, const std::vector<const Answer*>& answers, const Figure& figure);

/// Complete, each proven.
void check_proven(const Answer& answer, std::size_t count);
/// The same, with a real one.
void check_complete(const Answer& answer, std::size_t count);

/// By loops and by mixed cells; the figure is a solution. The answer is that by loops.
Answer check_counts(const ProblemStatement& problem, const Figure& figure, std::size_t count,
                    std::uint64_t seed = 1);

}  // namespace gcs::samples
