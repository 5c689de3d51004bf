#pragma once
/// A grid over the angles of a plan, scanned slice by slice: one for each value of the first angle, or one in all where
/// there is no angle.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/refined_solutions.hpp"

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

/// What the grid points of one slice give.
struct GridSlice {
  RefinedSolutions refined;
  std::int64_t coarse = 0;
  std::int64_t diverged = 0;
  std::int64_t newton_iterations = 0;
};

/// The report of a scan: some real solutions. `scan` is called for every slice, from several threads at once; slices are
/// taken in their order, whichever thread brings them when, so that the report is the same for any number of threads.
/// `none`: no solutions yet, of the kind that slices have. `candidates`: from the refined solutions of all. A grid of
/// more than `asked.max_points` points, or of none, is refused.
SolveReport scan_slices(const SolveRequest& request, const GridScan& asked, const RefinedSolutions& none,
                        const std::function<GridSlice(std::int64_t)>& scan,
                        const std::function<std::vector<Candidate>(const RefinedSolutions&)>& candidates);

}  // namespace gcs
