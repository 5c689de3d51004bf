#pragma once
/// S as a chain of proven arcs: for drawing it, and for saying where a point of it lies.

#include <optional>
#include <vector>

#include "solvers/tracking/arc_series.hpp"

namespace gcs {

/// The part first ≤ s ≤ last of a tube's arc (certification/path_tube.hpp), which is within `radius` of c(s)
/// in every coordinate and in 2-norm.
struct ProvenArc {
  ArcSeries curve;  ///< c, coordinates (X, t) in the scene's unit
  double first = 0, last = 0;
  double start = 0;   ///< arc length of S from the sketch to c(first)
  double radius = 0;  ///< in the scene's unit
  double turn = 0;    ///< a bound on |c''(s)|, one over the scene's unit
};

/// A corner of a polyline along S. The part of S from here to the next corner is within `radius` of the
/// segment.
struct PathNode {
  Eigen::VectorXd point;  ///< (X, t)
  double length = 0;      ///< arc length of S from the sketch
  double radius = 0;
};

/// The corners in order, the first one repeated at the end of a closed path. A curve leaves its chord by at
/// most |c''|·(last − first)²/8; the ends of arcs that follow each other are the same point of S.
std::vector<PathNode> polyline(const std::vector<ProvenArc>& arcs);

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
