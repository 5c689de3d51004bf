#pragma once
/// The crossings of a value of t on a piece of a tube's arc, proven.

#include <optional>
#include <vector>

#include "solvers/proven_paths/path_tube.hpp"

namespace gcs {

struct TubeCrossing {
  double s = 0;       ///< on the polynomial, near the arc's crossing
  int direction = 1;  ///< sign of dt along the arc
};

/// The sign of t − `level` at the arc's point at s; 0: not proven.
int side_of(const PathTube& tube, double level, double s);

/// All points where the arc meets t = `level` between two points of it whose s lie in `first` and `last`, in
/// order: where an enclosure of t − level holds 0, that of dt/ds does not, and the ends' signs tell whether
/// it is met; otherwise the piece is divided. Nothing where pieces of 2^-40 of the tube are not decided (the
/// arc touches the level or nearly so), or the sign at an end of the whole is not.
std::optional<std::vector<TubeCrossing>> crossings_of(const PathTube& tube, double level,
                                                      const ParameterRange& first,
                                                      const ParameterRange& last);

}  // namespace gcs
