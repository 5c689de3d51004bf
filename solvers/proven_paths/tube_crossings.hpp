#pragma once
/// Where the arc of a tube crosses a value of t, and where t stops growing along it, proven.

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

/// Along a piece of a tube's arc, t is proven to grow up to here and, where that is not the piece's end, to fall further on.
struct TubeGrowth {
  double until = 0;
  std::optional<double> falls_at;
};

/// Of the piece between two of the arc's points. Where it does not end the piece, the fold is as near beyond `until` as the
/// bounds of dt/ds tell.
TubeGrowth growth_of(const PathTube& tube, double first, double last);

/// A box that holds the arc between two of its points.
PointBox arc_between(const PathTube& tube, const ParameterRange& s);

/// A box around the arc's only point with t = `level` between two of its points. Nothing where t is not proven to differ
/// from it close by. Precondition: t grows between the two.
std::optional<PointBox> enclosed_crossing(const PathTube& tube, double level, const ParameterRange& s);

}  // namespace gcs
