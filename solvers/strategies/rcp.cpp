/// Tracks S in the driving parameters of a construction plan that is changed on the fly: Algorithm 1 of [I]
/// (§3, §4, §6, §7).
///
/// A plan places the points one by one as intersections of spheres. Where the constraints do not suffice, a
/// radius is a driving parameter k; as many constraints are removed from the plan and become the equations. S
/// is followed in (k, t) ∈ R^(d+1), d ≪ m. Near a boundary configuration (tangent spheres, γ ≤ α) the plan is
/// changed (Algorithms 2–4): an argument is exchanged for a new driving parameter, an earlier exchange is
/// undone, or a reference point is shifted.
///
/// Where [I] is silent or wrong:
/// - The first plan is derived with the fewest driving parameters (construction/derive.hpp), or given by the
///   file.
/// - For interCS the printed shift, at the larger of circle radius and a_i6, can leave γ below α
///   (r = 1, a_i6 = 12: 0.083); the circle's radius gives γ ≥ 1/√2.
/// - γ does not see p_i1 = p_i3, nor p' = c for interCS, where the intersection is as badly determined as at
///   a tangency. measure=guarded also watches the sine of the angle of intersection; with measure=published
///   (γ alone) trackers get stuck there, mode=paper on the icosahedron among them.
/// - Algorithm 4 is undefined where p_(i+1) lies on the line of the centres: a direction at a right angle is
///   taken.
/// - Algorithm 3's restoring branch names the wrong driving parameter: what leaves is the current one and its
///   reference.
/// - (h4)–(h6) are not proven beforehand: a radius that vanishes on S ends the tracking with that reason.
///
/// mode=fast is tracking/series_tracker.hpp on tracking/plan_curve.hpp: exact derivatives through the plan. A
/// step may pass a boundary configuration; γ is looked at where steps end. mode=paper is
/// tracking/euler_newton_tracker.hpp on tracking/paper_homotopies.hpp. swap=off keeps the first plan and only
/// finds the branch again (§3.4): an ablation.
///
/// Claims the solutions on S. Imbach, Mathis, Schreck, A Robust and Efficient Method for Solving Point
/// Distance Problems by Homotopy, 2016.

#include "solvers/strategies/rcp.hpp"

#include "solvers/construction/derive.hpp"
#include "solvers/tracking/paper_homotopies.hpp"
#include "solvers/tracking/path_options.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/plan_curve.hpp"

namespace gcs {
namespace {

constexpr double paper_step_max = 0.05;  // [I] §7.3.1, with a plan

class RcpStrategy final : public Strategy {
 public:
  explicit RcpStrategy(const Rcp& asked)
      : mode_(asked.mode), options_(path_options(asked.tracking, paper_step_max)) {
    plan_options_.swap = asked.swap;
    plan_options_.partial = asked.derivatives == Rcp::Derivatives::partial;
    plan_options_.rule.alpha = asked.alpha;
    plan_options_.rule.watch_sine = asked.measure == Rcp::Measure::guarded;
  }

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (const auto reason = why_no_path(scene)) return reason;
    return why_no_plan(scene);
  }

  void prepare(const SolveRequest& request) override {
    plan_ = first_plan(request.scene, plan_options_.rule);
  }

  SolveReport solve(const SolveRequest& request) override {
    const Scene& scene = request.scene;
    const TrackerContext context{request.stop, request.monitor};
    const Plan plan = plan_ ? *plan_ : first_plan(scene, plan_options_.rule);
    const Figure sketch = in_plan_frame(scene, plan, *scene.sketch());
    if (mode_ == Rcp::Mode::paper) {
      PaperPlanHomotopy homotopy(scene, plan, sketch, plan_options_);
      EulerNewtonTracker tracker(homotopy, options_.paper, context);
      return report_of(scene, tracker.run(), homotopy);
    }
    return report_once_refined(options_.fast, [&](const SeriesTrackerOptions& options) {
      PlanCurve curve(scene, plan, sketch,
                      {options.order, options.tolerance, plan_options_.swap, plan_options_.rule});
      SeriesTracker tracker(curve, options, context);
      return report_of(scene, tracker.run(), curve);
    });
  }

 private:
  template <class Curve>
  static SolveReport report_of(const Scene& scene, const TrackedPath& path, const Curve& curve) {
    SolveReport report = path_report(scene, path, [&](const Eigen::VectorXd& y) { return curve.figure(y); });
    report.paths.front().plans = curve.plans();
    return report;
  }

  Rcp::Mode mode_;
  PathOptions options_;
  PlanHomotopyOptions plan_options_;
  std::optional<Plan> plan_;
};

}  // namespace

StrategyEntry rcp_entry() {
  StrategyEntry entry = entry_of<RcpStrategy, Rcp>();
  entry.summary =
      "tracks S in the driving parameters of a construction plan changed on the fly (Algorithm 1)";
  entry.citation = "Imbach, Mathis, Schreck 2016, Algorithms 1 to 4";
  entry.needs_sketch = true;
  entry.accuracy_settings = path_accuracy_settings();
  return entry;
}

}  // namespace gcs
