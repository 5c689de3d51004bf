#pragma once
/// The fine mixed cells of a random lifting, of which polyhedral homotopies start: B. Huber, B. Sturmfels:
/// A polyhedral method for solving sparse polynomial systems, Math. Comp. 64 (1995). Their volumes add up to
/// the mixed volume, which bounds the number of isolated solutions without a zero coordinate and is that
/// number for generic coefficients (D. N. Bernshtein 1975).

#include <cstdint>
#include <stop_token>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/polyhedral/dictionary.hpp"
#include "solvers/polyhedral/exact_cell.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

struct MixedCell {
  CellEdges edges;             ///< the two points of each support that are lowest
  std::int64_t volume = 0;     ///< |det| of the edges: how many paths start here
  std::vector<double> normal;  ///< α, one per unknown, in the unit of the lifting
};

enum class MixedCellStatus {
  complete,
  stopped,    ///< on request, with no cells
  ties,       ///< every lifting that was tried was too special, or not to be told from such a one
  too_large,  ///< a volume, or a normal times it, does not fit 60 bits
};

struct MixedCells {
  MixedCellStatus status = MixedCellStatus::complete;
  Supports supports;             ///< those given; stable cells: with the origin appended where it was missing
  Lifting lifting;               ///< of these
  std::vector<MixedCell> cells;  ///< in lexicographic order of their edges
  int liftings_tried = 0;
  SimplexWork work;

  Natural total_volume() const;
};

struct MixedCellOptions {
  std::uint64_t seed = 0;
  int threads = 1;  ///< ≥ 1; changes nothing in the result
  std::stop_token stop;
};

/// Every cell is proved in integers: its normal solves the equations of its edges, and all other points are
/// higher. That no cell is missing rests on linear programs in doubles; a lifting with a decision too close
/// for them is given up for the next. Precondition: as many supports as unknowns, none empty.
MixedCells mixed_cells(const Supports& supports, const MixedCellOptions& options);

/// The stable mixed cells, whose volumes add up to the stable mixed volume: a bound on the number of all
/// isolated solutions in C^n. B. Huber, B. Sturmfels: Bernstein's theorem in affine space, Discrete Comput.
/// Geom. 17 (1997): the origin joins the supports that lack it, lifted by 1, the others by 0, and the mixed
/// volumes of the cells with normal ≥ 0 are added. Here these cells are subdivided by adding the random
/// lifting, small beside 1, as in T. Gao, T. Y. Li, X. Wang: Finding all isolated zeros of polynomial systems
/// in C^n via stable mixed volumes, J. Symb. Comput. 28 (1999). That it is small enough is checked for every
/// cell. Precondition: no negative exponents, and as above.
MixedCells stable_mixed_cells(const Supports& supports, const MixedCellOptions& options);

}  // namespace gcs
