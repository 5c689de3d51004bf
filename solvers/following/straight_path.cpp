#include "solvers/following/straight_path.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

namespace gcs {
namespace {

/// A crossing found by the tracker is good to about 1e-6 of the scene; further away Newton may have gone elsewhere.
constexpr double largest_refinement = 1e-3;

SeriesTrackerOptions tracker_options(const ArcSettings& settings) {
  SeriesTrackerOptions options;
  options.order = settings.order;
  options.tolerance = settings.tolerance;
  options.max_steps = settings.max_steps;
  options.step_max_far = 0.1;
  options.stops_at_fold = true;
  options.infinite_coordinate = infinite_coordinate;
  return options;
}

/// The path of points alone, in the frame of three of them, has fewer unknowns.
bool takes_elements(const Scene& scene) { return is_path_of_elements(scene) || scene.is_anchored(); }

/// Newton's method at t = 1 from a crossing (x, 1); false where it does not settle near by.
template <class Family>
bool refine_crossing(Family family, double size, Eigen::VectorXd& y) {
  constexpr int most_iterations = 8;
  const Eigen::Index m = family.unknowns();
  const Eigen::VectorXd start = y;
  Eigen::VectorXd residual(m);
  Eigen::MatrixXd jacobian(m, m + 1);
  y[m] = 1;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_iterations; ++i) {
    family.residual(y, residual);
    family.jacobian(y, jacobian);
    const Eigen::VectorXd correction = jacobian.leftCols(m).partialPivLu().solve(residual);
    const double length = correction.norm();
    if (!(length <= last / 2)) break;  // what is left is rounding
    y.head(m) -= correction;
    last = length;
    if (length <= std::numeric_limits<double>::epsilon() * y.norm()) break;
  }
  return last <= CorrectorTest::settled_limit(y.norm()) && (y - start).norm() <= largest_refinement * size;
}

class ArcFollower {
 public:
  ArcFollower(const Scene& scene, const ArcSettings& settings, const TrackerContext& context)
      : scene_(scene), options_(tracker_options(settings)), context_(context), proves_(settings.prove) {}

  StraightArc run() {
    const bool has_elements = takes_elements(scene_);
    if (auto reason = has_elements ? why_no_arc_of_elements() : why_no_path(scene_)) {
      arc_.end = ArcEnd::unsupported;
      arc_.reason = *std::move(reason);
      return std::move(arc_);
    }
    if (has_elements)
      prepare_elements();
    else
      arc_.values.assign(scene_.length_paths().begin(), scene_.length_paths().end());
    if (proves_ && follow_with_proof()) return std::move(arc_);
    arc_.end = ArcEnd::undecided;
    if (has_elements)
      follow_elements();
    else
      follow_points();
    return std::move(arc_);
  }

 private:
  std::optional<std::string> why_no_arc_of_elements() {
    if (!scene_.sketch()) return "there is no figure to begin at";
    if (auto reason = why_no_system(scene_)) return reason;
    system_.emplace(scene_);
    const QuadraticSystem& equations = system_->equations();
    if (static_cast<int>(equations.equations.size()) != equations.unknowns)
      return "the scene has not as many equations as unknowns";
    return std::nullopt;
  }

  void prepare_elements() {
    sketched_ = sketched_unknowns(scene_, *system_);
    if (!sketched_) return;
    const GeneralFamily family(scene_, *system_, sketched_->x, options_.order);
    arc_.values.resize(scene_.problem().constraints.size() + scene_.problem().relations.size());
    for (std::size_t e = 0; e < family.values().size(); ++e)
      if (const int number = system_->value_of()[e]; number >= 0)
        arc_.values[static_cast<std::size_t>(number)] = family.values()[e].path;
  }

  /// False where there is no proof.
  bool follow_with_proof() {
    if (auto reason = system_ ? std::nullopt : why_not_proven(scene_)) {
      arc_.why_unproven = *std::move(reason);
      return false;
    }
    const auto make_curve = system_ ? provable_curve_of_elements : provable_curve;
    CertifiedTracker tracker(make_curve(scene_, options_.order, options_.tolerance), options_, context_);
    const TrackedPath path = tracker.run();
    add(path.work, arc_.work);
    if (path.end == TrackedPath::End::stopped) return stop(path);
    if (!path.proven) {
      arc_.why_unproven = path.cause.empty() ? "the arc goes to infinity" : path.cause;
      return false;
    }
    take(path, tracker.figure(tracker.end_of_rise().mid));
    arc_.proven = true;
    arc_.error = error_within(tracker.end_of_rise());
    if (!system_ && arc_.end == ArcEnd::reached) sharpen(tracker.end_of_rise());
    return true;
  }

  /// The solution of points that is proven to be in the box, in a smaller one. Krawczyk's test holds in a box around both, so
  /// that they hold the same.
  void sharpen(const PointBox& end) {
    const DistanceSystem system(scene_);
    const std::vector<DoubleDouble> squares = target_squares(scene_);
    const Eigen::Index m = system.unknowns();
    Eigen::VectorXd x = end.mid.head(m);
    refine(system, squares, x);
    const double reach = ((x - end.mid.head(m)).cwiseAbs() + end.radius.head(m)).maxCoeff() * round_up;
    const auto holds_one = [&](double radius) {
      return krawczyk(system, squares, Box{x, Eigen::VectorXd::Constant(m, radius)}) ==
             BoxContent::one_solution;
    };
    if (!holds_one(reach)) return;
    double radius = 0x1p-51 * scene_.size();
    while (radius < reach && !holds_one(radius)) radius *= 8;
    if (radius >= reach) return;
    arc_.figure = system.figure(x);
    arc_.error = 2 * radius;  // 2 > √3
  }

  /// Of the figure at the middle of a box that holds the end of the arc.
  double error_within(const PointBox& end) const {
    const Eigen::Index m = end.mid.size() - 1;
    if (!system_) return end.radius.head(m).norm() * round_up;
    const ComplexValues x = system_->coordinates(arc_.figure);
    std::vector<double> offsets;
    for (Eigen::Index i = 0; i < m; ++i)
      offsets.push_back((std::abs(x[static_cast<std::size_t>(i)] - end.mid[i]) + end.radius[i]) * round_up);
    return system_->distance(arc_.figure, x, offsets);
  }

  bool stop(const TrackedPath& path) {
    arc_.end = ArcEnd::stopped;
    arc_.reason = path.cause;
    return true;
  }

  void follow_points() {
    options_.far = times_far_away(scene_.length_paths());
    const Reference reference = wide_reference(scene_);
    DistanceCurve curve(scene_, reference, options_.order, options_.tolerance);
    follow(curve, [&](const Eigen::VectorXd& y) { return scene_.in_frame(curve.figure(y)); });
  }

  void follow_elements() {
    if (!sketched_) {
      arc_.reason = too_far_from_incidences;
      return;
    }
    GeneralFamily family(scene_, *system_, sketched_->x, options_.order);
    options_.far = times_far_away(bounding_lengths(family.values()));
    GeneralCurve curve(std::move(family), options_.tolerance);
    follow(curve, [&](const Eigen::VectorXd& y) {
      return system_->figure(ComplexValues(y.begin(), y.end() - 1), true);
    });
  }

  template <class Curve, class FigureOf>
  void follow(Curve& curve, const FigureOf& figure_of) {
    TrackedPath path = SeriesTracker(curve, options_, context_).run();
    add(path.work, arc_.work);
    if (path.end == TrackedPath::End::stopped) {
      stop(path);
    } else if (path.end != TrackedPath::End::reached) {
      arc_.reason = path.cause.empty() ? "the arc goes to infinity" : path.cause;
    } else if (path.fold) {
      take(path, figure_of(path.fold->point));
    } else if (refine_crossing(curve.family(), scene_.size(), path.crossings.back().point)) {
      take(path, figure_of(path.crossings.back().point));
    } else {
      arc_.reason = "where the arc meets t = 1 Newton's method does not settle";
    }
  }

  void take(const TrackedPath& path, Figure figure) {
    arc_.end = path.fold ? ArcEnd::folds : ArcEnd::reached;
    if (path.fold) arc_.fold = path.fold->t;
    arc_.figure = std::move(figure);
  }

  const Scene& scene_;
  SeriesTrackerOptions options_;
  const TrackerContext& context_;
  bool proves_;
  std::optional<SceneSystem> system_;  ///< of more than points, or with given positions
  std::optional<SketchedUnknowns> sketched_;
  StraightArc arc_;
};

/// The frame puts a line on an axis in one of two directions: in that which leaves the points nearer to the sketch.
Figure in_frame_of_line(const Scene& scene, Figure figure) {
  const Figure one = scene.in_frame(figure);
  figure.lines[static_cast<std::size_t>(scene.reference().line)].direction *= -1;
  Figure other = scene.in_frame(figure);
  const auto moved = [&](const Figure& to) { return (to.points - scene.sketch()->points).squaredNorm(); };
  return moved(one) <= moved(other) ? one : other;
}

}  // namespace

StraightArc follow_straight(const Scene& scene, const ArcSettings& settings, const TrackerContext& context) {
  const Scene followed = in_frame_of_elements(scene);
  StraightArc arc = ArcFollower(followed, settings, context).run();
  const bool has_figure = arc.end == ArcEnd::reached || arc.end == ArcEnd::folds;
  if (!is_in_frame_of_line(scene) || !has_figure) return arc;
  arc.figure = in_frame_of_line(scene, arc.figure);
  arc.error = std::numeric_limits<double>::infinity();  // what it is in the line's frame is not known
  return arc;
}

}  // namespace gcs
