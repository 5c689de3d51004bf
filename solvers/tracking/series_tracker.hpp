#pragma once
/// The fast tracker of S: one Taylor polynomial in arc length per step.
///
/// Predictor. The equations are quadratic, so the Taylor coefficients of the curve cost one factorisation and one
/// solution with it each. The arc length parameter has no singularity at folds of t, and on a
/// circle it has none at all, which is why steps are long. The step is that at which the last two terms fall
/// below the tolerance, and no more than a part of the radius of convergence that the last ratios of
/// coefficients show: where two arcs nearly cross, the singularity between them is so weak that its terms are
/// below the tolerance even outside the disc.
///
/// Corrector. Simplified Newton in the hyperplane through the predicted point normal to the tangent, with the
/// same factorisation that gives the next polynomial. Its contraction measures the distance at which Newton
/// would leave the path; a step whose corrections do not contract, or that needs more than a few tolerances
/// of correction, is halved.
///
/// Three tests stand against jumps to another arc. The polynomial at the new point, evaluated one step
/// backwards, must meet the old point. The step must not leave the disc of the polynomial at the new point
/// either. And the curve refuses a point at which the determinant of the corrector's matrix has another sign:
/// so it has on the far side of a place where two arcs cross or nearly do, however near, which the other
/// tests do not see below about 1e-11. They are strong tests, not a proof: a step over two such places passes
/// the third one.
///
/// Crossings of t = 1 are roots of the polynomial. Where t may turn round near 1 the polynomial is computed
/// with the matrix at its own point, not with that of the corrector. Where t comes so near to 1, or passes it at so small
/// a slope, that the error of the polynomial hides the crossings, points are corrected to the rounding of their
/// coordinates from there on, and the step is halved while that helps. Near an extremum of t that is as near 1
/// as that series still errs the crossings are not known, and the extremum is recorded, too.
///
/// It fails (with a named cause) where S is singular, or passes a singularity closer than the smallest step,
/// where a length vanishes, beyond which the squared equations describe another problem, and where S runs off.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "solvers/numeric/polynomial_roots.hpp"
#include "solvers/tracking/arc_series.hpp"
#include "solvers/tracking/corrector.hpp"
#include "solvers/tracking/series_curve.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

struct SeriesTrackerOptions {
  int order = 12;
  double tolerance = 1e-7;  ///< size of the last terms kept, in the scene's unit
  double step_max = 1;      ///< arc length in (X, t)
  /// Far away a step may be longer than step_max: this part of the largest coordinate.
  double step_max_far = 0;
  std::int64_t max_steps = 1'000'000;
  int orientation = 1;
  bool stops_at_first = false;  ///< at the first solution
  bool stops_at_fold = false;   ///< there, too, or where t stops growing before
  TimeRange far{};              ///< S is given up beyond it
  /// A path with a coordinate beyond this has its end at infinity.
  double infinite_coordinate = std::numeric_limits<double>::infinity();
  int kept_points = 0;  ///< of each step, at equal arc lengths; crossings besides
};

/// Backward evaluation must meet the old point within this fraction of the step. A jump misses it by the
/// distance of the arcs, while a series that is good to 1e-9 one way is good to about 1e-5 the other (its
/// disc may be smaller by the step).
inline constexpr double backward_agreement = 1e-3;

/// The part of the radius of convergence, as estimated, that a step may use. Strong singularities keep steps
/// of order 12 to a third of it.
inline constexpr double disc_used = 0.75;

/// A length that is down to this part of itself where no step was possible is what makes S singular there.
inline constexpr double vanished = 1e-8;

/// Where nothing but the rounding of coordinates is left, a step may be this short, a few hundred roundings.
inline constexpr double least_wide_step = 1e-13;

/// How far along S, in the scene's unit, the error of t may move a crossing: Newton's method leads to the solution from
/// there.
inline constexpr double settled_crossing = 1e-4;

/// How far from an extremum of height h of t the crossings next to it may be, in units of sqrt(h/|t''|):
/// twice where a parabola puts them.
inline constexpr double touch_reach = 2.9;

/// The path is closed when it passes the start this close (relative to the size of (X, t)), in the same
/// direction: the error of a predicted point that the corrector still takes, or what rounding leaves of it.
inline double closing_distance(double tolerance) {
  return std::max(1e-9, CorrectorTest::first_limit * tolerance);
}

template <SeriesCurve Curve>
class SeriesTracker {
 public:
  SeriesTracker(Curve& curve, const SeriesTrackerOptions& options, const TrackerContext& context)
      : curve_(curve),
        options_(options),
        context_(context),
        here_(curve.coordinates(), options.order),
        there_(curve.coordinates(), options.order),
        beside_(curve.coordinates(), options.order) {}

  /// Follows the curve from its start until it is back there.
  TrackedPath run() {
    if (!curve_.start(options_.orientation, here_))
      return finish(TrackedPath::End::failed,
                    "the Jacobian is singular at the sketch: hypothesis (h1) fails there");
    start_ = here_.coefficient(0);
    start_tangent_ = here_.coefficient(1);
    while (curve_.work().iterations < options_.max_steps) {
      if (context_.stop.stop_requested()) return finish(TrackedPath::End::stopped, "stopped on request");
      if (!step()) return finish(TrackedPath::End::failed, too_small());
      if (options_.stops_at_fold && ends_rise()) return finish_rise();
      const double closing = closing_length();
      record_crossings(closing);
      keep_points(closing > 0 ? closing : step_);
      path_.length += closing > 0 ? closing : step_;
      if (closing > 0) return finish(TrackedPath::End::closed, "", closing);
      if (options_.stops_at_first && !path_.crossings.empty()) return finish(TrackedPath::End::reached, "");
      std::swap(here_, there_);
      if (auto cause = runs_off(options_.far, here_.coefficient(0)[t_row()]))
        return finish(TrackedPath::End::failed, *std::move(cause));
      if (here_.coefficient(0).lpNorm<Eigen::Infinity>() > options_.infinite_coordinate)
        return finish(TrackedPath::End::at_infinity, "");
      report_progress();
    }
    return finish(TrackedPath::End::failed, "max_steps reached before the path closed");
  }

 private:
  /// Where no step is short enough for points that the rounding of residuals moves, one may be for others.
  bool step() {
    if (take_step()) return true;
    if (is_wide_) return false;
    widen();
    return take_step();
  }

  bool take_step() {
    WorkCounters& work = curve_.work();
    const double far = options_.step_max_far * here_.coefficient(0).lpNorm<Eigen::Infinity>();
    step_ = std::min(
        {std::max(options_.step_max, far), here_.step_for(options_.tolerance), disc_used * here_.radius()});
    for (; step_ >= (is_wide_ ? least_wide_step : least_step); step_ /= 2) {
      here_.evaluate(step_, predicted_);
      here_.tangent(step_, tangent_);
      if (curve_.advance(predicted_, tangent_, there_, is_wide_) && step_ <= there_.radius() &&
          agrees_backwards()) {
        if (hides_crossings()) {
          sharpen();
          ++work.rejected_steps;
          continue;
        }
        curve_.accept();
        ++work.iterations;
        work.smallest_step = std::min(work.smallest_step.value_or(step_), step_);
        if (is_wide_ || may_touch(there_)) curve_.renew(there_);
        return true;
      }
      curve_.reject();
      ++work.rejected_steps;
    }
    return false;
  }

  /// Whether the error of t on this step hides where, or whether, t comes to 1, and that can be mended.
  bool hides_crossings() const {
    if (std::abs(here_.coefficient(0)[t_row()] - 1) > step_) return false;  // |dt/ds| ≤ 1
    const std::vector<double> above = height(here_);
    if (!may_vanish(above, step_, time_error_at(step_))) return false;
    const std::vector<double> rate = derivative(above);
    const auto can_be_mended = [&](double s) { return !is_wide_ || series_error_at(s) > rounding_of_time(); };
    return std::ranges::any_of(real_roots(above, step_),
                               [&](double s) {
                                 const double least_rate =
                                     std::abs(polynomial_value(rate, s)) -
                                     (is_wide_ ? 0 : CorrectorTest::stale_limit * options_.tolerance);
                                 return least_rate * settled_crossing < time_error_at(s) && can_be_mended(s);
                               }) ||
           std::ranges::any_of(real_roots(rate, step_), [&](double s) {
             return std::abs(polynomial_value(above, s)) <= time_error_at(s) && can_be_mended(s);
           });
  }

  /// From now on points are corrected to the rounding of their coordinates, first the one that the step begins at.
  void widen() {
    is_wide_ = true;
    predicted_ = here_.coefficient(0);
    tangent_ = here_.coefficient(1);
    if (curve_.advance(predicted_, tangent_, there_, is_wide_)) std::swap(here_, there_);
    curve_.reject();
  }

  /// Takes the step back: it is halved, but first tried again with points as exact as can be.
  void sharpen() {
    curve_.reject();
    if (is_wide_) return;
    widen();
    step_ *= 2;
  }

  bool agrees_backwards() {
    there_.evaluate(-step_, scratch_);
    scratch_ -= here_.coefficient(0);
    return scratch_.norm() <= backward_agreement * step_ && there_.coefficient(1).dot(tangent_) > 0;
  }

  /// Whether t may turn round near 1 on the steps before and after the point of the series.
  bool may_touch(const ArcSeries& series) const {
    const double reach = std::max(step_, series.step_for(options_.tolerance));
    if (std::abs(series.coefficient(0)[t_row()] - 1) > reach) return false;  // |dt/ds| ≤ 1
    const std::vector<double> above = height(series);
    return may_vanish(above, reach, 0) && may_vanish(derivative(above), reach, 0);
  }

  Eigen::Index t_row() const { return here_.coefficients().rows() - 1; }

  /// The coefficients of t(s) − 1.
  std::vector<double> height(const ArcSeries& series) const {
    std::vector<double> above(static_cast<std::size_t>(options_.order) + 1);
    for (int n = 0; n <= options_.order; ++n)
      above[static_cast<std::size_t>(n)] = series.coefficients()(t_row(), n) - (n == 0 ? 1 : 0);
    return above;
  }

  /// The start as it would be seen from here.
  void turn_start() {
    const Eigen::VectorXd signs = curve_.signs_towards(start_, here_.coefficient(0));
    start_.array() *= signs.array();
    start_tangent_.array() *= signs.array();
  }

  /// Where on this step the path is back at the start with the same tangent; 0: nowhere.
  double closing_length() {
    const double near = 2 * step_;
    if constexpr (TurnedCurve<Curve>) turn_start();
    if ((here_.coefficient(0) - start_).norm() > near && (there_.coefficient(0) - start_).norm() > near)
      return 0;
    const bool first = curve_.work().iterations == 1;
    std::vector<double> offset(static_cast<std::size_t>(options_.order) + 1);
    for (int n = 0; n <= options_.order; ++n)
      offset[static_cast<std::size_t>(n)] = start_tangent_.dot(here_.coefficient(n));
    offset[0] = first ? 0 : start_tangent_.dot(here_.coefficient(0) - start_);
    // The end of this polynomial and the start of the next differ by the tolerance.
    const double slack = 1 + 1e-3;
    for (double s : real_roots(offset, slack * step_)) {
      here_.evaluate(s, predicted_);
      here_.tangent(s, tangent_);
      const double distance = (predicted_ - start_).norm();
      if (distance <= closing_distance(options_.tolerance) * (1 + start_.norm()) &&
          tangent_.dot(start_tangent_) > 0.5 && !(first && s < step_ / 2))
        return s;
    }
    return 0;
  }

  /// Crossings of t = 1 on this step up to where the path is closed, if it is, and extrema of t next to it.
  void record_crossings(double closing) {
    const Eigen::Index t = t_row();
    const std::vector<double> above = height(here_);
    const bool ends_here = closing > 0;
    const double end = ends_here ? closing : step_;
    const double t_at_end = ends_here ? start_[t] : there_.coefficient(0)[t];
    if (!may_vanish(above, end, time_error_at(end)) && (above[0] >= 0) == (t_at_end >= 1)) return;
    int direction = above[0] >= 0 ? -1 : 1;
    for (const double s : sign_changes(above, end, t_at_end - 1)) {
      path_.crossings.push_back({point_at(s), direction, path_.length + s});
      direction = -direction;
    }
    const std::vector<double> rate = derivative(above);
    for (const double s : sign_changes(rate, end, ends_here ? start_tangent_[t] : there_.coefficient(1)[t]))
      record_touch(above, rate, s);
  }

  /// The series' point on this step, corrected where crossings are hidden by less than it errs: where S is flat, Newton's
  /// method at t = 1 leads far along it from a point that is a little beside.
  const Eigen::VectorXd& point_at(double s) {
    here_.evaluate(s, predicted_);
    if (!is_wide_) return predicted_;
    here_.tangent(s, tangent_);
    scratch_ = predicted_;
    if (!curve_.advance(scratch_, tangent_, beside_, is_wide_)) scratch_ = predicted_;
    curve_.reject();
    return scratch_;
  }

  /// Where t comes no nearer to 1 than the series errs, its extremum says all that there is to say.
  void record_touch(const std::vector<double>& above, const std::vector<double>& rate, double s) {
    const double height = std::abs(polynomial_value(above, s)), error = time_error_at(s);
    if (height > error) return;
    const double bend = polynomial_value(derivative(rate), s);
    const double reach = touch_reach * std::sqrt((height + error) / std::abs(bend));
    PathTouch touch{{}, {}, bend < 0 ? 1 : -1, path_.length + s, reach};
    if (!(reach <= step_)) touch.reach = std::numeric_limits<double>::infinity();
    touch.point = point_at(s);
    here_.evaluate(s - step_ / 16, touch.before);
    path_.touches.push_back(std::move(touch));
  }

  /// A bound on the error of t(s) near an extremum, where the series is that at its own point, for all that
  /// the corrector shows: it refuses a prediction that is off by more than so many of the last terms, and
  /// stops at the rounding of ill-conditioned points.
  double time_error_at(double s) const { return series_error_at(s) + rounding_of_time(); }

  double series_error_at(double s) const {
    const int last = options_.order;
    const auto coefficient = [&](int n) { return std::abs(here_.coefficients()(t_row(), n)); };
    const double terms = (coefficient(last) * s + coefficient(last - 1)) * std::pow(s, last - 1);
    return CorrectorTest::first_limit * terms;
  }

  double rounding_of_time() const { return rounding_at(here_.coefficient(0)); }

  /// What the corrector leaves of a point's coordinates.
  double rounding_at(const Eigen::Ref<const Eigen::VectorXd>& y) const {
    const double size = y.lpNorm<Eigen::Infinity>();
    return is_wide_ ? CorrectorTest::wide_limit(size) : CorrectorTest::settled_limit(size);
  }

  /// Whether t comes to 1 on this step, or turns round before.
  bool ends_rise() {
    const std::vector<double> above = height(here_), rate = derivative(above);
    const std::vector<double> turns = sign_changes(rate, step_, there_.coefficient(1)[t_row()]);
    const double end = turns.empty() ? step_ : turns.front();
    if (!turns.empty()) path_.fold = fold_near(end);
    const double t_at_end = turns.empty() ? there_.coefficient(0)[t_row()] : path_.fold->point[t_row()];
    if (t_at_end >= 1) {
      const double s = sign_changes(above, end, t_at_end - 1).front();
      here_.evaluate(s, predicted_);
      path_.crossings.push_back({predicted_, 1, path_.length + s});
    }
    path_.length += path_.crossings.empty() ? end : path_.crossings.back().at - path_.length;
    return t_at_end >= 1 || !turns.empty();
  }

  /// The extremum of t near this place on the step: that of the polynomial at a point of the curve beside it.
  PathFold fold_near(double s) {
    double error = time_error_at(s);
    here_.evaluate(s, predicted_);
    here_.tangent(s, tangent_);
    if (curve_.advance(predicted_, tangent_, there_, is_wide_)) {
      curve_.accept();
      curve_.renew(there_);
      const std::vector<double> rate = derivative(height(there_));
      there_.evaluate(-rate[0] / rate[1], predicted_);
      error = rounding_at(predicted_);
    } else {
      curve_.reject();
    }
    const double t = predicted_[t_row()];
    return {predicted_, {t - error, t + error}};
  }

  TrackedPath finish_rise() {
    if (path_.fold && path_.fold->t.low <= 1 && path_.fold->t.high >= 1)
      return finish(TrackedPath::End::failed, touches_target);
    if (!path_.crossings.empty()) path_.fold.reset();
    return finish(TrackedPath::End::reached, "");
  }

  /// The sign changes of a polynomial in (0, end], of which the next one has the value `at_end` at its start.
  /// The corrector moves the end by less than the tolerance; that must neither lose nor double one.
  static std::vector<double> sign_changes(const std::vector<double>& polynomial, double end, double at_end) {
    std::vector<double> roots = real_roots(polynomial, end);
    const bool odd = (polynomial[0] >= 0) != (at_end >= 0);
    if (odd == (roots.size() % 2 == 1)) return roots;
    if (!roots.empty() && roots.back() > end * (1 - 1e-3))
      roots.pop_back();
    else
      roots.push_back(std::abs(polynomial[0]) < std::abs(at_end) ? 0 : end);
    std::sort(roots.begin(), roots.end());
    return roots;
  }

  std::string too_small() const {
    const double t = here_.coefficient(0)[t_row()];
    const bool vanishes = curve_.shortest_length(t) <= vanished;
    return step_too_small(t) + (vanishes ? ": a length vanishes there or nearly so (hypothesis h2)"
                                         : ": S is singular there or nearly so (hypothesis h1)");
  }

  void report_progress() {
    if (context_.monitor && curve_.work().iterations % 256 == 0) context_.monitor->progress("tracking S", -1);
  }

  /// From the point of the series on; the crossings there are known.
  void keep_points(double length) {
    if (options_.kept_points == 0) return;
    std::vector<double> places;
    for (int i = 0; i < options_.kept_points; ++i) places.push_back(length * i / options_.kept_points);
    for (const PathCrossing& crossing : path_.crossings)
      if (crossing.at >= path_.length) places.push_back(crossing.at - path_.length);
    std::ranges::sort(places);
    for (const double s : places) keep_point(s);
  }

  void keep_point(double s) {
    here_.evaluate(s, predicted_);
    path_.points.push_back(predicted_);
  }

  /// So far from the point of the series.
  TrackedPath finish(TrackedPath::End end, std::string cause, double s = 0) {
    if (!path_.points.empty()) keep_point(s);
    path_.end = end;
    path_.cause = std::move(cause);
    path_.work = curve_.work();
    return std::move(path_);
  }

  Curve& curve_;
  SeriesTrackerOptions options_;
  TrackerContext context_;
  ArcSeries here_, there_, beside_;
  double step_ = 0;
  bool is_wide_ = false;  ///< corrections are to leave nothing but the rounding of coordinates
  Eigen::VectorXd start_, start_tangent_, predicted_, tangent_, scratch_;
  TrackedPath path_;
};

}  // namespace gcs
