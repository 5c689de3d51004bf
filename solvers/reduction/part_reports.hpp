#pragma once
/// What reports on the parts of a scene have in common.

#include <vector>

#include "solvers/figures/solution_classes.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Adds the particulars of the same name.
void add(const std::vector<Particular>& more, std::vector<Particular>& particulars);

bool claims_all(Claim claim);

/// Whether all points lie in the plane of the frame, which is that of the base: to rounding, unless the figure is proven to
/// be next to a simple solution, as `error` may say. All distances are stationary when a flat figure leaves its plane.
bool is_own_mirror_image(const Scene& scene, const Figure& representative, double error);

/// The classes of figures in the scene's unit, by proven errors where condition numbers take some for the same; these
/// become part of `accuracies`.
ReflectionClasses classes_told_apart(const Scene& scene, const std::vector<Figure>& figures,
                                     std::vector<SolutionAccuracy>& accuracies);

/// `is_empty`: one of them proves that there is no solution.
SolveStatus common_status(const std::vector<SolveReport>& reports, bool is_empty);

/// The weakest of the claims.
Claim common_claim(const std::vector<SolveReport>& reports);

}  // namespace gcs
