#pragma once
/// A scan over a grid of the angles of a plan of points, lines and planes, [H] §5.

#include "solvers/construction/element_plan.hpp"
#include "solvers/scanning/grid_slices.hpp"

namespace gcs {

/// At each point of the grid every branch of the plan is a coarse solution where no equation of the scene, of whatever
/// kind of constraint, is further than `delta` from being met, to first order: |f| ≤ delta·|∇f| in the unknowns of
/// elements/scene_system.hpp. So is, in a wider band, one whose surfaces miss each other by so little that they may meet
/// between two points of the grid, where a branch can begin and end. Newton's method on the whole system starts from it; ends of the same class are one
/// solution. It can miss solutions as grid_scan does: some real ones. `asked.delta` in the scene's unit. The same for any
/// number of threads.
SolveReport element_scan(const SolveRequest& request, const ElementPlan& plan, const GridScan& asked);

}  // namespace gcs
