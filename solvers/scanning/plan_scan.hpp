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

#include <cstdint>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// A range of angles on which some branch could not be decided.
struct UndecidedPiece {
  std::vector<std::array<double, 2>> ranges;  ///< one per angle, in radians
  Figure figure;  ///< in the plan's frame: its middle, or where Newton's method goes from there
};

/// A proven solution, in the plan's frame.
struct ScanSolution {
  Figure figure;
  double error = 0;  ///< bound on the distance of each point from its place, in the scene's unit
};

struct ScanOutcome {
  enum class End { complete, too_many_cells, too_many_undecided, stopped };
  End end = End::complete;
  std::vector<ScanSolution> solutions;  ///< distinct
  std::vector<UndecidedPiece> undecided;
  std::int64_t cells = 0;
  double share = 0;        ///< of the whole that is decided, roughly
  std::int64_t boxes = 0;  ///< to which Krawczyk's test was put
  std::int64_t newton_iterations = 0;
};

/// Gives up after max_cells. Of the request, its scene is scanned, and its stop and monitor are used.
/// Precondition: the plan has at most three angles, or two and a line.
ScanOutcome scan_plan(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells);

}  // namespace gcs
