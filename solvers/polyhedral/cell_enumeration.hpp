#pragma once
/// All mixed cells of a lifting, by enumeration with linear programs: an edge of one support after the other,
/// as long as somewhere all edges so far are lowest, that is ⟨a, α⟩ + ω(a) = ⟨b, α⟩ + ω(b) ≤ ⟨c, α⟩ + ω(c)
/// for the other points c of the support. The next support is the one with fewest edges left, T. Mizutani, A.
/// Takeda, M. Kojima: Dynamic enumeration of all mixed cells, Discrete Comput. Geom. 37 (2007). Which are
/// left is found anew at every node, for all supports that are to come, so that a dead end shows early; the
/// linear programs for it share their bases, T. Gao, T. Y. Li: Mixed volume computation for semi-mixed
/// systems, Discrete Comput. Geom. 29 (2003). When it fails: the number of nodes grows exponentially with the
/// number of unknowns, and where few points are lowest together (a system that hangs together loosely) it is
/// much larger than that of the cells.

#include <stop_token>
#include <vector>

#include "solvers/polyhedral/dictionary.hpp"
#include "solvers/polyhedral/exact_cell.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

struct EnumeratedCells {
  std::vector<CellEdges> cells;  ///< in lexicographic order
  SimplexWork work;              ///< with near ties the cells are in doubt
};

/// Cells and counts do not depend on `threads` ≥ 1. Ends early, with some of the cells, when `stop` says so.
EnumeratedCells enumerate_cells(const Supports& supports, const Lifting& lifting, int threads,
                                const std::stop_token& stop);

}  // namespace gcs
