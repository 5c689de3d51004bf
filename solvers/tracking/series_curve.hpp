#pragma once
/// What the series tracker asks of a curve.

#include <Eigen/Core>
#include <concepts>

#include "solvers/running/work.hpp"
#include "solvers/tracking/arc_series.hpp"

namespace gcs {

/// A curve in coordinates whose last one is t.
template <class C>
concept SeriesCurve = requires(C curve, int orientation, double t, Eigen::VectorXd& y,
                               const Eigen::VectorXd& tangent, ArcSeries& series, bool is_wide) {
  /// Number of coordinates, t included.
  { curve.coordinates() } -> std::convertible_to<Eigen::Index>;
  /// The series at the start, going towards growing t (orientation +1) or falling t;
  /// false where S is singular.
  { curve.start(orientation, series) } -> std::same_as<bool>;
  /// Corrects the predicted point y in the hyperplane normal to the tangent and expands there; false when the
  /// corrector does not settle, when y is on another arc, or when a length is negative there. `is_wide`: with residuals
  /// in double-double, so that nothing but the rounding of the coordinates is left.
  { curve.advance(y, tangent, series, is_wide) } -> std::same_as<bool>;
  /// Expands again at the point of the last advance, once that is taken, with a matrix at this very point.
  curve.renew(series);
  /// The least of the lengths at t, each relative to what it is at the sketch or the target.
  { curve.shortest_length(t) } -> std::convertible_to<double>;
  /// The last advance is taken, or taken back.
  curve.accept();
  curve.reject();
  /// Counters kept by the curve itself.
  { curve.work() } -> std::same_as<WorkCounters&>;
};

/// A curve on which points are the same figure that differ in the signs of some coordinates.
template <class C>
concept TurnedCurve = requires(const C curve, const Eigen::VectorXd& y) {
  /// Of all coordinates, 1 or −1: those that bring the first point nearest to the second.
  { curve.signs_towards(y, y) } -> std::same_as<Eigen::VectorXd>;
};

}  // namespace gcs
