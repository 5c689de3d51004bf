#pragma once
/// All real solutions of a general scene by scanning the angles of a plan of points, lines and planes: subdivision with
/// proof.
///
/// The subdivision is that of plan_scan.hpp. Elements are placed in enclosures (element_pieces.hpp), from which those of
/// the unknowns of elements/scene_system.hpp follow (element_unknowns.hpp); equations of constraints that place nothing are
/// checks, whatever their kind, and Krawczyk's test is that of all equations.

#include <optional>
#include <string>

#include "solvers/construction/element_plan.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/scan_outcome.hpp"

namespace gcs {

/// Why the plan is not scanned with proof, in a sentence: which constraint has unknowns that do not follow from the elements,
/// or which step no enclosures; nothing where it is.
std::optional<std::string> why_no_element_subdivision(const Scene& scene, const ElementPlan& plan);

/// Gives up after max_cells. Of the request, its scene is scanned, and its stop and monitor are used.
/// Precondition: nothing from why_no_element_subdivision.
ScanOutcome subdivide_element_plan(const SolveRequest& request, const ElementPlan& plan,
                                   std::int64_t max_cells);

}  // namespace gcs
