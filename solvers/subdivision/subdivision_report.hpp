#pragma once
/// What a subdivision of a scene's equations reports.

#include <stop_token>

#include "solvers/certificates/scene_equations.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/subdivision/subdivision.hpp"

namespace gcs {

/// The solutions, each class once, with the claim that they are all real ones. Undecided boxes are decided by counting,
/// where that is possible (certificates/undecided_place.hpp). Where boxes stay undecided, or
/// were not looked at, the status says so and the reason counts and names them; points of them that satisfy
/// the constraints to rounding are reported too.
SolveReport subdivision_report(const Scene& scene, const SceneEquations& equations,
                               const SubdivisionOutcome& outcome, const std::stop_token& stop);

}  // namespace gcs
