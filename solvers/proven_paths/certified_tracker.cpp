#include "solvers/proven_paths/certified_tracker.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {
namespace {

/// How much of a tube is used: the next one has to hold the end, and the sketch must not fall between two.
constexpr std::array<double, 4> used_parts{0.96, 0.9, 0.83, 0.75};

/// The part of the expected half length at which the next centre is tried first.
constexpr double first_reach = 0.88;

/// A trial after a failed one, relative to it.
constexpr double shrink = 0.7;

}  // namespace

std::optional<std::string> why_not_proven(const Scene& scene) {
  if (is_path_of_elements(scene))
    return scene.sketch() ? why_no_system(scene)
                          : "a path strategy starts from a sketch, and the instance has none";
  if (const auto reason = why_no_path(scene)) return reason;
  if (scene.is_anchored() || scene.constraint_count() == 0)
    return "S is proven in scenes of constraints between points in the frame only, where nothing is fixed";
  return std::nullopt;
}

CertifiedTracker::CertifiedTracker(const Scene& scene, const SeriesTrackerOptions& options,
                                   const TrackerContext& context)
    : CertifiedTracker(provable_curve(scene, options.order, options.tolerance), options, context) {}

CertifiedTracker::CertifiedTracker(std::unique_ptr<ProvableCurve> curve, const SeriesTrackerOptions& options,
                                   const TrackerContext& context)
    : options_(options),
      context_(context),
      curve_(std::move(curve)),
      start_(curve_->exact().equations, curve_->exact().data, curve_->exact().turnings),
      here_(curve_->exact().equations, curve_->exact().data.lengths, options.order),
      there_(here_),
      series_(curve_->coordinates(), options.order) {
  options_.far = curve_->exact().far;
}

TrackedPath CertifiedTracker::run() {
  if (!curve_->exact().no_start.empty()) return finish(TrackedPath::End::failed, curve_->exact().no_start);
  if (!curve_->start(options_.orientation, series_) || !there_.expand(series_))
    return finish(TrackedPath::End::failed,
                  "the Jacobian is singular at the sketch: hypothesis (h1) fails there");
  WorkCounters& work = curve_->work();
  double half_length =
      std::min({options_.step_max, series_.step_for(options_.tolerance), there_.promising_half_length()});
  Failure failure = first_tube(half_length);
  for (; failure != Failure::none && half_length > least_step; failure = first_tube(half_length)) {
    half_length *= shrink;
    ++work.rejected_steps;
  }
  if (failure != Failure::none) return finish(TrackedPath::End::failed, cause(failure));
  take();
  while (!stretch_.closes) {
    if (stretch_.end_of_rise) return finish_rise();
    if (options_.stops_at_first && !path_.crossings.empty()) return finish(TrackedPath::End::reached, "");
    if (context_.stop.stop_requested()) return finish(TrackedPath::End::stopped, "stopped on request");
    if (work.iterations >= options_.max_steps)
      return finish(TrackedPath::End::failed, "max_steps reached before the path closed");
    if (auto far_away = runs_off(options_.far, exit_.point.mid[curve_->coordinates() - 1]))
      return finish(TrackedPath::End::failed, *std::move(far_away));
    if (exit_.point.mid.lpNorm<Eigen::Infinity>() > options_.infinite_coordinate)
      return finish(TrackedPath::End::at_infinity, "");
    if (!advance()) return finish(TrackedPath::End::failed, path_.cause);
    take();
    if (context_.monitor && work.iterations % 256 == 0) context_.monitor->progress("proving S", -1);
  }
  path_.proven = true;
  return finish(TrackedPath::End::closed, "");
}

CertifiedTracker::Failure CertifiedTracker::first_tube(double half_length) {
  if (!there_.prove(half_length, there_.room_for(start_.start(), Eigen::MatrixXd(0, curve_->coordinates()))))
    return Failure::proof;
  stretch_ = {};
  const PlaceInTube start = start_.locate(there_);
  if (start.kind != PlaceInTube::Kind::inside) return Failure::link;
  stretch_.entry = start.s;
  return end_stretch(there_, true, stretch_);
}

bool CertifiedTracker::advance() {
  Failure furthest = Failure::none;
  for (double ahead = ahead_; ahead >= least_step; ahead *= shrink) {
    const Failure failure = next_tube(ahead);
    if (failure == Failure::none) return true;
    furthest = std::max(furthest, failure);
    ++curve_->work().rejected_steps;
  }
  path_.cause = cause(furthest);
  return false;
}

CertifiedTracker::Failure CertifiedTracker::next_tube(double ahead) {
  Eigen::VectorXd from, y, tangent;
  here_.curve().evaluate(exit_s_, from);
  here_.curve().evaluate(exit_s_ + ahead, y);
  here_.curve().tangent(exit_s_ + ahead, tangent);
  y += exit_.point.mid - from;
  if (!curve_->advance(y, tangent, series_) || !there_.expand(series_)) return Failure::corrector;
  stretch_ = {};
  const double needed = ahead / first_reach;
  const double longest = std::max(options_.step_max, options_.step_max_far * from.lpNorm<Eigen::Infinity>());
  const double most =
      std::min({longest, series_.step_for(options_.tolerance), there_.promising_half_length(), 2 * needed});
  const Eigen::ArrayXd room = there_.room_for(exit_.point, exit_.spread);
  Failure failure = Failure::proof;
  for (double h = std::max(most, needed); h >= needed; h = std::max(h * shrink, h > needed ? needed : 0))
    if (there_.prove(h, room)) {
      failure = Failure::none;
      break;
    }
  if (failure == Failure::none) failure = link(there_, stretch_);
  if (failure == Failure::none) failure = end_stretch(there_, false, stretch_);
  return failure;
}

CertifiedTracker::Failure CertifiedTracker::link(const PathTube& tube, Stretch& stretch) const {
  const PlaceInTube place = tube.locate(exit_.point, exit_.spread);
  if (place.kind != PlaceInTube::Kind::inside) return Failure::link;
  const PointBox tangent = tube.tangent(place.s);
  const Eigen::VectorXd a = exit_.tangent.mid.cwiseAbs(), b = tangent.mid.cwiseAbs();
  const double error = a.dot(tangent.radius) + b.dot(exit_.tangent.radius) +
                       exit_.tangent.radius.dot(tangent.radius) +
                       static_cast<double>(a.size()) * std::numeric_limits<double>::epsilon() * a.dot(b);
  if (!(exit_.tangent.mid.dot(tangent.mid) > error * round_up)) return Failure::direction;
  stretch.entry = place.s;
  return Failure::none;
}

/// The sketch cannot lie on the first stretch again: s grows along a tube's arc.
CertifiedTracker::Failure CertifiedTracker::end_stretch(const PathTube& tube, bool is_first,
                                                        Stretch& stretch) const {
  if (options_.stops_at_fold) return rise(tube, stretch);
  const double used = used_parts[0] * tube.half_length();
  std::optional<ParameterRange> close;
  if (!is_first) {
    const PlaceInTube sketch = start_.locate(tube);
    if (sketch.kind == PlaceInTube::Kind::inside && sketch.s.high > stretch.entry.low) {
      if (!(sketch.s.low > stretch.entry.high)) return Failure::closing;
      if (sketch.s.low <= used) close = sketch.s;
    }
    if (sketch.kind == PlaceInTube::Kind::unknown) return Failure::closing;
  }
  stretch.closes = close.has_value();
  for (const double part : used_parts) {
    const double at_part = part * tube.half_length();
    stretch.exit = close.value_or(ParameterRange{at_part, at_part});
    if (side_of(tube, 1, stretch.exit.low) == 0) continue;
    const auto crossings = crossings_of(tube, 1, stretch.entry, stretch.exit);
    if (!crossings) return Failure::crossing;
    stretch.crossings = *crossings;
    return Failure::none;
  }
  return Failure::crossing;
}

/// As t grows, the sketch is not met again.
CertifiedTracker::Failure CertifiedTracker::rise(const PathTube& tube, Stretch& stretch) const {
  for (const double part : used_parts) {
    const double last = part * tube.half_length();
    const TubeGrowth growth = growth_of(tube, stretch.entry.low, last);
    if (growth.until < last && !growth.falls_at) continue;
    stretch.exit = {growth.until, growth.until};
    const int side = side_of(tube, 1, growth.until);
    if (growth.until == last && side < 0) return Failure::none;
    if (side > 0) return end_of_rise(tube, growth.until, stretch);
    if (!growth.falls_at) continue;
    stretch.exit.high = *growth.falls_at;
    stretch.end_of_rise = arc_between(tube, stretch.exit);
    const Eigen::Index time = curve_->coordinates() - 1;
    return stretch.end_of_rise->mid[time] + stretch.end_of_rise->radius[time] < 1 ? Failure::none
                                                                                  : Failure::crossing;
  }
  return Failure::growth;
}

/// The crossing of t = 1 on the part used.
CertifiedTracker::Failure CertifiedTracker::end_of_rise(const PathTube& tube, double until,
                                                        Stretch& stretch) const {
  stretch.end_of_rise = enclosed_crossing(tube, 1, {stretch.entry.high, until});
  if (!stretch.end_of_rise) return Failure::crossing;
  stretch.crossings = {{until, 1}};
  return Failure::none;
}

TrackedPath CertifiedTracker::finish_rise() {
  const PointBox& end = *stretch_.end_of_rise;
  const Eigen::Index time = curve_->coordinates() - 1;
  const double reach =
      end.radius[time] + std::numeric_limits<double>::epsilon();  // t ≤ 1 and its sums are rounded
  if (path_.crossings.empty())
    path_.fold = {end.mid, {end.mid[time] - reach, end.mid[time] + reach}};
  else
    path_.crossings.back().point = end.mid;
  path_.proven = true;
  return finish(TrackedPath::End::reached, "");
}

void CertifiedTracker::take() {
  WorkCounters& work = curve_->work();
  std::swap(here_, there_);
  const double step = stretch_.exit.low - stretch_.entry.low;
  ++work.iterations;
  work.smallest_step = std::min(work.smallest_step.value_or(step), step);
  if (keeps_arcs_)
    arcs_.push_back({here_.curve(), stretch_.entry.low, stretch_.exit.high, path_.length,
                     (here_.radius() + here_.polynomial_error()).norm() * round_up, here_.turn(),
                     stretch_.crossings});
  path_.length += step;
  for (const TubeCrossing& crossing : stretch_.crossings)
    path_.crossings.push_back({here_.at(crossing.s).point.mid, crossing.direction});
  exit_s_ = stretch_.exit.low;
  ahead_ = first_reach * here_.half_length();
  if (!stretch_.closes && !stretch_.end_of_rise) exit_ = here_.at(exit_s_);
}

std::string CertifiedTracker::cause(Failure failure) const {
  const Eigen::Index last = series_.coefficients().rows() - 1;
  const std::string where = " near t = " + std::to_string(series_.coefficients()(last, 0));
  switch (failure) {
    case Failure::none:
      break;
    case Failure::corrector:
      return "no next point was found" + where + ": S is singular there or nearly so (hypothesis h1)";
    case Failure::proof:
      return "no tube could be proven" + where + ": S is singular there or nearly so (hypothesis h1)";
    case Failure::link:
      return "no tube that holds the end of the last one could be proven" + where;
    case Failure::direction:
      return "the direction of travel could not be proven" + where;
    case Failure::crossing:
      return "the crossings of t = 1 could not be decided" + where + ": S touches it there or nearly so";
    case Failure::growth:
      return "it could not be decided whether t still grows" + where + ": S is singular there or nearly so";
    case Failure::closing:
      return "it could not be decided whether S is back at the sketch" + where;
  }
  return "";
}

TrackedPath CertifiedTracker::finish(TrackedPath::End end, std::string cause) {
  path_.end = end;
  path_.cause = std::move(cause);
  path_.work = curve_->work();
  return std::move(path_);
}

}  // namespace gcs
