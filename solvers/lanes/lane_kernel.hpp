#pragma once
/// Predictor and corrector, one path per SIMD lane, for any kind of equations that come with their Jacobian
/// and the right-hand sides of their Taylor series: SquareEquations, MonomialEquations.
///
/// Predictor: the Taylor series of x(s), whose coefficients follow from one factorised Jacobian, continued
/// beyond the last one by the nearest two poles that it tells (series_tail.hpp). With the radius of
/// convergence ρ, which the last coefficients tell, ℓ = ρ|x_1| is the way that the path goes until the series
/// diverges: a length that scales with the scene and is short where other branches are near. A step is so
/// long that the neglected part is `tolerance`·ℓ, at least as long as the series alone allows, which is a
/// fixed part of ρ, and always shorter than ρ.
///
/// Corrector: one step of Newton's method with a residual in two doubles, in place of a second
/// factorisation: the Jacobian at the predicted point serves the correction and the next series. A step whose
/// correction is larger than the prediction's error should be is taken back; the series is then taken anew
/// with the Jacobian at the corrected point, for near singular ones feel the difference. That no step jumps
/// to another path is likely, not proven.

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "solvers/lanes/complex_lanes.hpp"
#include "solvers/lanes/lane_factors.hpp"
#include "solvers/lanes/lane_tracker.hpp"
#include "solvers/lanes/series_tail.hpp"

namespace gcs::GCS_LANES {

template <class Equations>
class KernelTracker final : public LaneTracker {
 public:
  using Number = typename Equations::Number;
  using Real = decltype(Number::re);

  KernelTracker(const typename Equations::System& system, const Elimination& elimination,
                const TrackingOptions& options)
      : equations_(system, elimination, options.order),
        elimination_(elimination),
        options_(options),
        n_(system.unknowns),
        order_(options.order),
        part_of_radius_(std::pow(options.tolerance, 1.0 / options.order)),
        x_(n_),
        predicted_(n_),
        change_(n_),
        series_((order_ + 1) * n_),
        factors_(elimination) {}

  int lanes() const override { return Real::count; }
  bool is_busy(int lane) const override { return paths_[lane].phase != Phase::idle; }
  LegState state(int lane) const override { return paths_[lane].state; }

  void load(int lane, const Leg& leg) override {
    for (int i = 0; i < n_; ++i) {
      set(x_[i], lane, leg.start[i]);
      for (int k = 0; k <= order_; ++k) set(term(i, k), lane, 0);
      set(term(i, 0), lane, leg.start[i]);
    }
    equations_.load(lane, *leg.route);
    paths_[lane] = Path{};
    paths_[lane].phase = leg.from > 0 ? Phase::resuming : Phase::starting;
    paths_[lane].state.s = leg.from;
    paths_[lane].shortest_step = leg.shortest_step;
  }

  void read(int lane, std::complex<double>* x) const override {
    for (int i = 0; i < n_; ++i) x[i] = {x_[i].re.lane(lane), x_[i].im.lane(lane)};
  }

  void step() override {
    const Real h = step_lengths();
    predict(h);
    factorise();
    correct();
    if (const Real accepted = judge(); any_moves()) extend_series(accepted);
  }

 private:
  static constexpr int sizes_kept = 3;         ///< of the last coefficients: some vanish by symmetry
  static constexpr double longest_part = 0.6;  ///< of ρ: beyond, what a denominator foretells is seldom right
  static constexpr double allowance = 16;      ///< times the expected error: one bad step in a radius
  static constexpr double rounding = 1e-15;    ///< a correction of that size says nothing about the step
  static constexpr double furthest_start = 1e-6;  ///< a start point's or end point's distance from its zero
  static constexpr double almost_one = 1 - 1e-14;

  enum class Phase { idle, starting, resuming, moving, renewing, arriving };

  struct Path {
    Phase phase = Phase::idle;
    LegState state{};
    double h = 0;      ///< the step to try
    double reach = 0;  ///< ℓ at the point where the series was taken
    double scale = 0;  ///< 1 + the largest |x_i|
    int rejected_in_a_row = 0;
    double shortest_step = 0;  ///< of the leg
    bool is_repeated = false;  ///< the last correction
  };

  /// Where the step ends. Its length is the way to there: rounded, s and h would disagree on short ones.
  static double target(const Path& path) {
    return path.phase == Phase::moving ? path.state.s + path.h : path.state.s;
  }

  Real step_lengths() const {
    Real h;
    for (int lane = 0; lane < Real::count; ++lane)
      h.set_lane(lane, target(paths_[lane]) - paths_[lane].state.s);
    return h;
  }

  /// The coefficient of s^k in the series of unknown i.
  Number& term(int i, int k) { return series_[i * (order_ + 1) + k]; }
  const Number& term(int i, int k) const { return series_[i * (order_ + 1) + k]; }

  void predict(Real h) {
    const auto [last, last_but_one] = tail_.weights(h);
    for (int i = 0; i < n_; ++i) {
      Number sum = fused(last, term(i, order_), product(last_but_one, term(i, order_ - 1)));
      for (int k = order_ - 2; k >= 0; --k) sum = fused(h, sum, term(i, k));
      predicted_[i] = sum;
    }
  }

  /// The equations at the predicted point, with the Jacobian's factors.
  void factorise() {
    Real s, arriving;
    for (int lane = 0; lane < Real::count; ++lane) {
      const double s_of_lane = target(paths_[lane]);
      s.set_lane(lane, s_of_lane);
      arriving.set_lane(lane, s_of_lane == 1 ? 1 : 0);
    }
    equations_.evaluate(predicted_, s, arriving, factors_.cleared_entries());
    factors_.factorise();
  }

  void correct() {
    for (int k = 0; k < n_; ++k) change_[k] = equations_.residual(elimination_.equation[k], predicted_);
    factors_.solve(change_);
  }

  /// Decides on every lane's step; x_ of the accepted ones moves. Not 0 for an accepted lane.
  Real judge() {
    Real correction, extent;
    for (int k = 0; k < n_; ++k) {
      correction = larger(correction, size_of(change_[k]));
      // A number that is none must not pass for small.
      extent = extent + size_of(change_[k]);
    }
    Real largest;
    for (int i = 0; i < n_; ++i) largest = larger(size_of(predicted_[i]), largest);
    Real accepted;
    for (int lane = 0; lane < Real::count; ++lane) {
      const bool finite = std::isfinite(extent.lane(lane));
      const double size = finite ? correction.lane(lane) : std::numeric_limits<double>::infinity();
      paths_[lane].scale = 1 + largest.lane(lane);
      accepted.set_lane(lane, decide(paths_[lane], size) ? 1 : 0);
    }
    for (int k = 0; k < n_; ++k) {
      const int i = elimination_.unknown[k];
      x_[i] = selected(accepted, predicted_[i] - change_[k], x_[i]);
    }
    return accepted;
  }

  bool decide(Path& path, double correction) const {
    path.state.last_correction = correction / path.scale;
    switch (path.phase) {
      case Phase::idle:
        return false;
      case Phase::starting:
        if (!(correction <= furthest_start * path.scale)) return finish(path, LegEnd::too_small);
        path.phase = Phase::moving;
        return true;
      case Phase::resuming:  // a series is to say how near it must be
        return std::isfinite(correction) || finish(path, LegEnd::too_small);
      case Phase::renewing:
        path.phase = Phase::moving;
        return std::isfinite(correction);
      case Phase::moving:
        return decide_step(path, correction);
      case Phase::arriving:
        if (!(correction <= furthest_start * path.scale)) return finish(path, LegEnd::too_small);
        if (path.state.is_settled() || std::exchange(path.is_repeated, true)) finish(path, LegEnd::arrived);
        return true;
    }
    return false;
  }

  /// Of a point as near to the path as that part of how far it goes until its series diverges.
  static double largest_correction(const Path& path, double part) {
    return allowance * std::max(rounding * path.scale, part * std::min(path.reach, path.scale));
  }

  bool decide_step(Path& path, double correction) const {
    ++path.state.steps;
    if (path.state.steps > options_.most_steps) return finish(path, LegEnd::too_many);
    if (!(correction <= largest_correction(path, options_.tolerance))) {
      ++path.state.rejected;
      reject(path);
      return false;
    }
    path.rejected_in_a_row = 0;
    path.state.s += path.h;
    if (path.state.s == 1) path.phase = Phase::arriving;
    return true;
  }

  static bool resume(Path& path) {
    if (!(path.state.last_correction * path.scale <= largest_correction(path, furthest_start)))
      return finish(path, LegEnd::too_small);
    path.phase = path.state.s == 1 ? Phase::arriving : Phase::moving;
    return true;
  }

  /// First the series is taken again, with a Jacobian at the point itself; then the step is halved.
  void reject(Path& path) const {
    ++path.rejected_in_a_row;
    const bool most_fail =
        path.state.rejected > options_.most_rejected && 2 * path.state.rejected > path.state.steps;
    if (path.rejected_in_a_row > options_.most_rejected || most_fail)
      finish(path, path.shortest_step > 0 ? LegEnd::short_steps : LegEnd::too_small);
    else if (path.rejected_in_a_row == 1)
      path.phase = Phase::renewing;
    else
      path.h /= 2;
  }

  static bool finish(Path& path, LegEnd end) {
    path.state.end = end;
    path.phase = Phase::idle;
    return false;
  }

  bool any_moves() const {
    return std::any_of(paths_.begin(), paths_.end(),
                       [](const Path& path) { return path.phase != Phase::idle; });
  }

  /// The series at x_ of the accepted lanes; the others keep theirs.
  void extend_series(Real accepted) {
    for (int i = 0; i < n_; ++i) store(accepted, i, 0, x_[i]);
    Real s;
    for (int lane = 0; lane < Real::count; ++lane) s.set_lane(lane, paths_[lane].state.s);
    equations_.begin_series(series_, s);
    std::array<Real, sizes_kept> last;
    Real first;
    for (int k = 1; k <= order_; ++k) {
      equations_.right_sides(k, series_, change_);
      factors_.solve(change_);
      for (int step = 0; step < n_; ++step) store(accepted, elimination_.unknown[step], k, change_[step]);
      if (k == 1) first = largest_change();
      if (k > order_ - sizes_kept) last[k - (order_ - sizes_kept) - 1] = largest_change();
    }
    tail_.fit(series_, order_);
    for (int lane = 0; lane < Real::count; ++lane)
      if (accepted.lane(lane) != 0) choose_step(lane, first, last);
  }

  void store(Real accepted, int i, int k, const Number& value) {
    term(i, k) = selected(accepted, value, term(i, k));
  }

  Real largest_change() const {
    Real size;
    for (const Number& change : change_) size = larger(size, size_of(change));
    return size;
  }

  void choose_step(int lane, Real first, const std::array<Real, sizes_kept>& last) {
    Path& path = paths_[lane];
    if (path.phase != Phase::moving && path.phase != Phase::resuming) return;
    double radius = std::numeric_limits<double>::infinity();
    for (int i = 0; i < sizes_kept; ++i) {
      const int k = order_ - sizes_kept + 1 + i;
      radius = std::min(radius, std::pow(first.lane(lane) / last[i].lane(lane), 1.0 / (k - 1)));
    }
    // A path that stands still has no radius; its whole leg is one step.
    path.reach = first.lane(lane) > 0 ? radius * first.lane(lane) : std::numeric_limits<double>::max();
    if (path.phase == Phase::resuming && (!resume(path) || path.phase == Phase::arriving)) return;
    const double h = first.lane(lane) > 0 ? longest_step(lane, radius, path.reach) : 1;
    path.h = std::min(h, 1 - path.state.s);
    if (path.state.s + path.h > almost_one) path.h = 1 - path.state.s;
    if (h < path.shortest_step)
      finish(path, LegEnd::short_steps);
    else if (!(path.state.s + path.h > path.state.s))
      finish(path, LegEnd::too_small);
  }

  /// h with misfit·h^N/|D(h)| = tolerance·ℓ, D(h) by two iterations, within its bounds. Where numbers
  /// overflow the lower bound is left.
  double longest_step(int lane, double radius, double reach) const {
    const double power = options_.tolerance * reach / tail_.misfit().lane(lane);
    const double shortest = part_of_radius_ * radius, longest = longest_part * radius;
    double h = shortest;
    for (int i = 0; i < 2; ++i) {
      const double denominator = std::min(1.0, std::sqrt(tail_.squared_denominator(lane, h)));
      h = std::pow(power * denominator, 1.0 / order_);
      h = h > shortest ? std::min(h, longest) : shortest;
    }
    return h;
  }

  Equations equations_;
  const Elimination& elimination_;
  const TrackingOptions options_;
  const int n_;
  const int order_;
  const double part_of_radius_;  ///< that the series alone allows
  std::array<Path, Real::count> paths_{};
  std::vector<Number> x_;
  std::vector<Number> predicted_;
  std::vector<Number> change_;
  std::vector<Number> series_;  ///< [unknown][order]
  SeriesTail<Real> tail_;
  LaneFactors<Number> factors_;  ///< of the Jacobian at predicted_
};

}  // namespace gcs::GCS_LANES
