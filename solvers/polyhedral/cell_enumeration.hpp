#pragma once
/// All mixed cells of a lifting, by enumeration with linear programs: an edge of one support after the other,
/// as long as somewhere all edges so far are lowest, that is ⟨a, α⟩ + ω(a) = ⟨b, α⟩ + ω(b) ≤ ⟨c, α⟩ + ω(c)
/// for the other points c of the support. The next support is the one with fewest edges left, T. Mizutani, A.
/// Takeda, M. Kojima: Dynamic enumeration of all mixed cells, Discrete Comput. Geom. 37 (2007); the linear
/// programs for the edges of a support share their bases, T. Gao, T. Y. Li: Mixed volume computation for
/// semi-mixed systems, Discrete Comput. Geom. 29 (2003).
/// Deviations: which edges are left is not looked up in a table of pairs but found by linear programs at
/// every node, for the supports that have an unknown in common with the newest edge; and a node is given up
/// when the edges left cannot be independent. Both let dead ends show early where a system hangs together
/// loosely. When it fails: the number of nodes grows exponentially with the number of unknowns, whatever the
/// number of cells.

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
