#pragma once
/// A scan over a grid of a plan's angles, [H] §5: n − k equations are solved for given values of k driving
/// parameters, and ρ = max |f_j| of the k others is looked at.

#include "solvers/scanning/grid_slices.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// At each point of the grid every branch of the plan on which all checks hold up to `delta` is a coarse
/// solution. Newton's method on the whole system starts from it, with residuals in double-double; equal ends
/// are one refined solution. It can miss solutions: where a check touches 0 between two points of the grid or
/// a branch ends there, and where Newton's method ends elsewhere than it began. Hence the claim: some real
/// ones. `work.evaluations` counts points of the grid, of which those are left out at whose first angles every
/// branch has ended or left the band. The same for any number of threads.
SolveReport grid_scan(const SolveRequest& request, const ScanPlan& plan, const GridScan& asked);

}  // namespace gcs
