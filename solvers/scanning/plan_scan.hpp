#pragma once
/// All real solutions of a scene by scanning its plan's angles: subdivision with proof.
///
/// Over a cell of angles every branch of the plan is followed with enclosures of its points. A branch leaves
/// a cell where a discriminant is negative or a check cannot hold on all of it; linear parts of discriminants
/// and checks narrow the cell. What is left is a small box of points around it, of which Krawczyk's test
/// proves that it holds one solution or none; where it cannot, the cell is halved. Nothing depends on the
/// width of the first cells: branch ends (a discriminant may be zero) and extrema of a check only mean
/// smaller cells around them. Near a branch end a point's height takes the place of an angle
/// (height_placing.hpp), and the cell is halved in it: what is unknown of the points then falls with the
/// square of its width there too. The solutions found are all there are, except in the pieces that are named
/// as undecided when the cells become too fine: there a solution is multiple, or nearly so. All this is
/// proven for the exact decimals of the file.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/scan_outcome.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// Gives up after max_cells. Of the request, its scene is scanned, and its stop and monitor are used.
/// Precondition: the plan has at most three angles, or two and a line.
ScanOutcome scan_plan(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells);

}  // namespace gcs
