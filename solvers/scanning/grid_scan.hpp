#pragma once
/// A scan over a grid of a plan's angles, [H] §5: n − k equations are solved for given values of k driving
/// parameters, and ρ = max |f_j| of the k others is looked at.

#include <limits>
#include <optional>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// The values first, first + step, … of an angle, in degrees.
struct AngleGrid {
  double first = 0;
  double step = 1;
  std::int64_t count = 0;

  /// In radians.
  double at(std::int64_t i) const;
};

/// Those of a range, in radians, that are `start` degrees from its beginning, and by whole steps more; its end
/// excluded. A quotient within rounding of a whole number is that number.
AngleGrid grid_over(const std::array<double, 2>& range, double start, double step);

struct GridScan {
  std::vector<AngleGrid> angles;  ///< one for each of the plan's
  double delta = 0;               ///< the band: how near 0 ρ must come, in the scene's unit
  std::int64_t max_points = std::numeric_limits<std::int64_t>::max();  ///< a larger grid is refused
  /// Refined solutions that are mirror images of each other are two.
  bool mirror_images_apart = false;
};

/// What is reported of a grid that is refused; nothing of any other.
std::optional<SolveReport> refused_grid(const GridScan& asked);

/// At each point of the grid every branch of the plan on which all checks hold up to `delta` is a coarse
/// solution. Newton's method on the whole system starts from it, with residuals in double-double; equal ends
/// are one refined solution. It can miss solutions: where a check touches 0 between two points of the grid or
/// a branch ends there, and where Newton's method ends elsewhere than it began. Hence the claim: some real
/// ones. `work.evaluations` counts points of the grid, of which those are left out at whose first angles every
/// branch has ended or left the band. The same for any number of threads.
SolveReport grid_scan(const SolveRequest& request, const ScanPlan& plan, const GridScan& asked);

}  // namespace gcs
