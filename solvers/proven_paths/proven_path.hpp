#pragma once
/// S as a chain of proven arcs: for drawing it, and for saying where a point of it lies.

#include <optional>
#include <vector>

#include "solvers/proven_paths/tube_crossings.hpp"
#include "solvers/tracking/arc_series.hpp"

namespace gcs {

/// The part first ≤ s ≤ last of a tube's arc (proven_paths/path_tube.hpp), which is within `radius` of c(s),
/// exact or as evaluate() rounds it, in every coordinate and in 2-norm. Arcs that follow each other overlap.
struct ProvenArc {
  ArcSeries curve;  ///< c, coordinates (X, t) in the scene's unit
  double first = 0, last = 0;
  double start = 0;                     ///< arc length of S from the sketch to c(first)
  double radius = 0;                    ///< in the scene's unit
  double turn = 0;                      ///< a bound on |c''(s)|, one over the scene's unit
  std::vector<TubeCrossing> crossings;  ///< all crossings of t = 1, in order
};

/// A corner of a polyline along S, in the scene's unit. The part of S from here to the next corner is within
/// `radius` of the segment between the two, in the 2-norm of (X, t).
struct PathNode {
  Eigen::VectorXd point;  ///< (X, t)
  double length = 0;      ///< arc length of S from the sketch, not enclosed
  double radius = 0;      ///< 0 at the last corner
  int crossing = 0;       ///< where S crosses t = 1 the sign of dt, elsewhere 0
};

/// A polyline along the closed path that `arcs` make up. The first corner is the sketch, and the last one the
/// same point again; every crossing of t = 1 is a corner. Between these there are as few as a greedy search
/// finds so that every radius is at most `within` > 0, in the scene's unit, or little more than that of the
/// arcs where this is larger. All rounding is in the radii.
std::vector<PathNode> polyline(const std::vector<ProvenArc>& arcs, double within);

/// Where a point lies on a proven path.
class PathPlaces {
 public:
  /// `arcs`, not empty, must outlive this. `tolerance`: how far from S a point may be and still be taken for
  /// one of it, in the scene's unit.
  PathPlaces(const std::vector<ProvenArc>& arcs, double tolerance) : arcs_(arcs), tolerance_(tolerance) {}

  /// Arc length from the sketch; nothing for a point off the path. The arcs around the last place found are
  /// tried first.
  std::optional<double> find(const Eigen::VectorXd& point);

 private:
  std::optional<double> on_arc(std::size_t index, const Eigen::VectorXd& point) const;

  const std::vector<ProvenArc>& arcs_;
  double tolerance_;
  std::size_t last_ = 0;
};

}  // namespace gcs
