#include "solvers/tracking/general_path.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/tracking/flat_refinement.hpp"
#include "solvers/tracking/general_curve.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

namespace gcs {
namespace {

class TargetValues : public TargetEquations {
 public:
  explicit TargetValues(const SceneSystem& system) : system_(system), equations_(system.equations()) {}

  Eigen::VectorXd coordinates(const Eigen::VectorXd& point) const override {
    return point.head(equations_.in_doubles().unknowns);
  }
  Refinement refine(Eigen::VectorXd& x) const override {
    constexpr int most_iterations = 40;  // next to a double solution each halves what a crossing is off
    return refine(x, most_iterations);
  }
  Refinement refine(Eigen::VectorXd& x, int most_iterations) const;
  std::optional<Eigen::VectorXd> refine_where_flat(const Eigen::VectorXd& x, double most) const override {
    return flat_refinement(equations_, x, most);
  }
  /// In doubles two solutions and none are not told apart.
  std::optional<FoldSolutions> at_fold(const Eigen::VectorXd&, WorkCounters&) const override {
    return std::nullopt;
  }
  std::optional<FoldSolutions> proven_at_fold(const Eigen::VectorXd& near) const override;
  Figure figure(const Eigen::VectorXd& x) const override {
    return system_.figure(ComplexValues(x.begin(), x.end()), true);
  }
  double proven_error(const Figure&) const override { return std::numeric_limits<double>::infinity(); }

 private:
  const SceneSystem& system_;
  WideEquations equations_;
};

std::optional<FoldSolutions> TargetValues::proven_at_fold(const Eigen::VectorXd& near) const {
  constexpr int solutions = 2;
  const ResolvedCandidates found =
      simple_solutions_near(system_, ComplexValues(near.begin(), near.end()), solutions, {});
  if (found.list.size() != solutions) return std::nullopt;
  FoldSolutions result;
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    if (!found.list[i].figure.is_real()) continue;
    result.x.push_back(real_parts(found.unknowns[i]));
    result.errors.push_back(found.list[i].error);
  }
  if (!result.x.empty() && !found.are_told_apart) return std::nullopt;
  return along_their_line(std::move(result));
}

Refinement TargetValues::refine(Eigen::VectorXd& x, int most_iterations) const {
  constexpr double ulp = std::numeric_limits<double>::epsilon(), settled = 1e-6;
  const Eigen::VectorXd start = x;
  const RealEquations& in_doubles = equations_.in_doubles();
  Eigen::MatrixXd jacobian(in_doubles.count(), in_doubles.unknowns);
  Refinement result;
  double size = 0, last = std::numeric_limits<double>::infinity();
  while (result.iterations < most_iterations) {
    in_doubles.jacobian(x, jacobian);
    const Eigen::VectorXd correction = jacobian.partialPivLu().solve(equations_.excess(x));
    x -= correction;
    ++result.iterations;
    result.last_correction = correction.norm();
    if (!std::isfinite(result.last_correction)) break;
    size = x.cwiseAbs().maxCoeff();
    if (result.last_correction <= 4 * ulp * size) break;
    // Rounding keeps an ill-conditioned solution from settling to the last bit.
    if (result.last_correction <= settled * size && result.last_correction > last / 2) break;
    last = result.last_correction;
  }
  result.converged = result.last_correction <= settled * size;
  if (!result.converged) x = start;
  return result;
}

/// Of points that are tracked in another frame: solutions are refined in the scene's.
class TargetValuesInFrame final : public TargetValues {
 public:
  TargetValuesInFrame(const Scene& scene, const SceneSystem& system, const SceneSystem& tracked)
      : TargetValues(system), scene_(scene), system_(system), tracked_(tracked) {}

  Eigen::VectorXd coordinates(const Eigen::VectorXd& point) const override {
    const Figure figure = tracked_.figure(ComplexValues(point.begin(), point.end() - 1), true);
    return real_parts(system_.coordinates(scene_.in_frame(figure)));
  }

 private:
  const Scene& scene_;
  const SceneSystem &system_, &tracked_;
};

SolveReport given_up(const std::string& reason) {
  SolveReport report;
  report.claim = Claim::on_path;
  report.reason = reason;
  return report;
}

/// In millionths of the scene's unit.
Particular moved(const SketchedUnknowns& sketched) {
  return {"sketch_moved_millionths", std::llround(1e6 * sketched.moved)};
}

/// A half of S seen the other way, from infinity to the sketch.
TrackedPath reversed(TrackedPath path) {
  for (PathCrossing& crossing : path.crossings) {
    crossing.direction = -crossing.direction;
    crossing.at = -crossing.at;
  }
  for (PathTouch& touch : path.touches) {
    touch.before = 2 * touch.point - touch.before;
    touch.at = -touch.at;
  }
  std::ranges::reverse(path.crossings);
  std::ranges::reverse(path.touches);
  std::ranges::reverse(path.points);
  return path;
}

class GeneralPath {
 public:
  using Follow = std::function<TrackedPath(const SeriesTrackerOptions&)>;

  GeneralPath(const Scene& scene, const SceneSystem& system, Follow follow_half)
      : scene_(scene), system_(system), follow_half_(std::move(follow_half)) {}

  TrackedPath follow(SeriesTrackerOptions options) const {
    options.infinite_coordinate = infinite_coordinate;
    if (options.stops_at_first) return follow_to_first(options);
    TrackedPath path = follow_half_(options);
    if (path.end != TrackedPath::End::at_infinity) return path;
    options.orientation = -options.orientation;
    return joined(path, follow_half_(options));
  }

 private:
  /// The tracker does not know signs: where it stops at a solution that is not as stated, S is followed to its end and cut
  /// at the first one that is.
  TrackedPath follow_to_first(SeriesTrackerOptions options) const {
    TrackedPath path = follow_half_(options);
    if (path.end == TrackedPath::End::reached && first_as_stated(path) == path.crossings.end()) {
      options.stops_at_first = false;
      path = follow_half_(options);
      if (const auto first = first_as_stated(path); first != path.crossings.end()) {
        std::erase_if(path.touches, [&](const PathTouch& touch) { return touch.at > first->at; });
        path.crossings.erase(first + 1, path.crossings.end());
        path.end = TrackedPath::End::reached;
      }
    }
    if (path.end == TrackedPath::End::at_infinity) {
      path.end = TrackedPath::End::failed;
      path.cause = "S goes to infinity and meets no solution on the way";
    }
    return path;
  }

  std::vector<PathCrossing>::iterator first_as_stated(TrackedPath& path) const {
    constexpr double found_to = 1e-6;  // of the scene's size: what a tracker's crossing is good to
    const std::vector<StatedSign> signs = stated_signs(scene_.problem());
    return std::ranges::find_if(path.crossings, [&](const PathCrossing& crossing) {
      const Eigen::VectorXd& y = crossing.point;
      const Figure figure = system_.figure(ComplexValues(y.begin(), y.end() - 1), true);
      return verdict_on(signs, figure, found_to * scene_.size()).standing == Standing::as_stated;
    });
  }

  const Scene& scene_;
  const SceneSystem& system_;
  Follow follow_half_;
};

/// S by the system of `tracked`, which is the scene in this frame or another one; its crossings in the scene's.
SolveReport follow_in_frame(const Scene& tracked, const SceneSystem& system, const Scene& scene,
                            const TargetEquations& target, const SeriesTrackerOptions& options,
                            const FollowHalf& follow_half) {
  const auto sketched = sketched_unknowns(tracked, system);
  if (!sketched) return given_up(too_far_from_incidences);
  const GeneralPath path(scene, system, [&](const SeriesTrackerOptions& of_half) {
    return follow_half(system, sketched->x, of_half);
  });
  SolveReport report = report_once_refined(options, [&](const SeriesTrackerOptions& refined) {
    return path_report(scene, path.follow(refined), target);
  });
  report.particulars.push_back(moved(*sketched));
  return report;
}

/// Follows a half of S by series of the curve that is made of its equations.
template <class CurveOf>
FollowHalf by_series(const Scene& scene, const TrackerContext& context, const CurveOf& curve_of) {
  return [&scene, &context, curve_of](const SceneSystem& system, const Eigen::VectorXd& sketched,
                                      const SeriesTrackerOptions& options) {
    GeneralFamily family(scene, system, sketched, options.order);
    SeriesTrackerOptions with_far = options;
    with_far.far = times_far_away(bounding_lengths(family.values()));
    auto curve = curve_of(system, std::move(family), options.tolerance);
    return SeriesTracker(curve, with_far, context).run();
  };
}

}  // namespace

std::unique_ptr<TargetEquations> target_values(const SceneSystem& system) {
  return std::make_unique<TargetValues>(system);
}

/// With the end of the second, which tells whether all is there.
TrackedPath joined(const TrackedPath& first, const TrackedPath& second) {
  TrackedPath path = reversed(second);
  path.crossings.insert(path.crossings.end(), first.crossings.begin(), first.crossings.end());
  path.touches.insert(path.touches.end(), first.touches.begin(), first.touches.end());
  if (!path.points.empty() && !first.points.empty())  // both have the start
    path.points.insert(path.points.end(), first.points.begin() + 1, first.points.end());
  path.length += first.length;
  add(first.work, path.work);
  return path;
}

std::vector<LengthPath> bounding_lengths(const std::vector<TravellingValue>& values) {
  std::vector<LengthPath> lengths;
  for (const TravellingValue& value : values)
    if (!value.is_plain) lengths.push_back(value.path);
  return lengths;
}

SolveReport follow_general_path(const Scene& scene, const SeriesTrackerOptions& options,
                                const TrackerContext& context) {
  return follow_general_path(
      scene, options,
      by_series(scene, context, [](const SceneSystem&, GeneralFamily family, double tolerance) {
        return GeneralCurve(std::move(family), tolerance);
      }));
}

SolveReport follow_general_plan(const Scene& scene, const ElementPlan& plan,
                                const SeriesTrackerOptions& options, const ElementCurveOptions& of_curve,
                                const TrackerContext& context) {
  const Scene in_plan_frame = plan.frame().origin < 0 ? scene : with_reference(scene, plan.frame());
  const auto curve_of = [&](const SceneSystem& system, GeneralFamily family, double tolerance) {
    ElementCurveOptions refined = of_curve;
    refined.tolerance = tolerance;
    return ElementCurve(std::move(family), plan_blocks(system, plan), refined);
  };
  const SceneSystem system(scene), tracked(in_plan_frame);
  return follow_in_frame(in_plan_frame, tracked, scene, TargetValuesInFrame(scene, system, tracked), options,
                         by_series(in_plan_frame, context, curve_of));
}

SolveReport follow_general_path(const Scene& scene, const SeriesTrackerOptions& options,
                                const FollowHalf& follow_half) {
  const SceneSystem system(scene);
  return follow_in_frame(scene, system, scene, TargetValues(system), options, follow_half);
}

SolveReport newton_from_general_sketch(const Scene& scene) {
  constexpr int most_iterations = 200;
  const SceneSystem system(scene);
  const auto sketched = sketched_unknowns(scene, system);
  if (!sketched) return report_of_newton(given_up(too_far_from_incidences));
  const TargetValues target(system);
  Eigen::VectorXd x = sketched->x;
  const Refinement refinement = target.refine(x, most_iterations);
  TrackedPath path;
  path.work.newton_iterations = path.work.factorisations = refinement.iterations;
  if (refinement.converged) {
    path.end = TrackedPath::End::reached;
    path.crossings.push_back({x, 1});
  } else {
    path.cause = "Newton's method from the sketch does not settle";
  }
  SolveReport report = report_of_newton(path_report(scene, path, target));
  report.particulars.push_back(moved(*sketched));
  return report;
}

}  // namespace gcs
